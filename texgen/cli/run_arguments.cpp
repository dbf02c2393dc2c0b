// SPDX-License-Identifier: Apache-2.0

#include "texgen/cli/run_arguments.h"

#include "texgen/bake/file_pattern.h"
#include "texgen/bake/frame_range.h"
#include "texgen/cache/cache_files.h"
#include "texgen/cli/options.h"
#include "texgen/cli/standard_error.h"
#include "texgen/material/profile.h"
#include "texgen/preset/load_preset.h"
#include "texgen/preset/preset_io.h"
#include "texgen/preset/preset_remarks.h"
#include "texgen/preset/shipped_presets.h"

#include <CLI/CLI.hpp>
#include <fmt/core.h>

#include <algorithm>
#include <cstddef>
#include <utility>

namespace foam::texgen {

namespace {

/// Returns the list [W, H] for "WxH", or [W, W] for "W". A part that is not a number is rejected
/// later, when the list is assigned to the key.
Value size_value(const std::string& size) {
    const std::size_t x = size.find('x');
    const std::string width = size.substr(0, x);
    const std::string height = x == std::string::npos ? width : size.substr(x + 1);
    return {Value::List{read_value(width), read_value(height)}};
}

std::vector<Assignment> concatenated(std::vector<Assignment> first,
                                     const std::vector<Assignment>& second) {
    first.insert(first.end(), second.begin(), second.end());
    return first;
}

/// Applies the assignments of the profile, of the command line and `more` to a preset. `own` are
/// the assignments in the file of the preset, which have been applied already. Unless -q is given,
/// prints the remarks (remarks_on) on the preset and on all these assignments, except those of the
/// profile.
Preset assigned(Preset preset,
                const std::vector<Assignment>& own,
                const RunArguments& arguments,
                const std::vector<Assignment>& more) {
    const std::vector<Assignment> assignments = concatenated(assignments_of(arguments), more);
    if (arguments.profile) {
        assign(preset, profile_assignments(*arguments.profile, preset, assignments));
    }
    assign(preset, assignments);
    if (!arguments.quiet) {
        for (const std::string& line : remarks_on(preset, concatenated(own, assignments))) {
            print_stderr("foamtex: note: {}", line);
        }
    }
    return preset;
}

/// Throws PresetError if a cache is given in place of a preset. The message says which commands
/// accept a cache. The name of a shipped preset is never an error, even if a cache has this name.
void check_is_no_cache(const std::string& preset) {
    const auto shipped = shipped_presets();
    if (is_cache(preset) &&
        std::ranges::find(shipped, preset, &ShippedPreset::name) == shipped.end()) {
        throw PresetError(fmt::format(
            "'{0}' has simulated states, but is not a preset; 'foamtex render {0}' draws images of "
            "them, and 'foamtex stats {0}' measures them",
            preset));
    }
}

}  // namespace

void add_preset_argument(CLI::App& command, RunArguments& arguments) {
    command.add_option("PRESET", arguments.preset, "Name of a shipped preset, or a .toml file")
        ->required()
        ->option_text(" ");
}

void add_set_option(CLI::App& command, RunArguments& arguments) {
    command.add_option("--set", arguments.sets, "Set one key of the preset; may be repeated")
        ->allow_extra_args(false)
        ->option_text("KEY=VALUE");
}

void add_preset_options(CLI::App& command, RunArguments& arguments) {
    add_preset_argument(command, arguments);
    add_frame_options(command, arguments);
    command
        .add_option("--seed",
                    arguments.seed,
                    "Seed of the random numbers, for a different foam of the same kind")
        ->option_text("N");
}

void add_frame_options(CLI::App& command, RunArguments& arguments) {
    add_set_option(command, arguments);
    add_frames_option(command, arguments.frames);
    command.add_option("--size", arguments.size, "Image size in pixels")->option_text("W[xH]");
}

void add_profile_option(CLI::App& command, RunArguments& arguments) {
    command
        .add_option("--for",
                    arguments.profile,
                    "Maps, packing and names for an engine: unreal, blender, ...; or a .toml file")
        ->option_text("PROFILE");
}

void add_run_options(CLI::App& command, RunArguments& arguments) {
    add_threads_option(command, arguments.threads);
    CLI::Option* const quiet = add_quiet_option(command, arguments.quiet);
    CLI::Option* const verbose =
        command.add_flag("-v,--verbose", arguments.verbose, "Print one line per frame")
            ->excludes(quiet)
            ->option_text(" ");
    add_progress_option(command, arguments.progress)->excludes(quiet)->excludes(verbose);
}

Value list_value(const std::string& words) {
    Value::List list;
    for (const std::string& word : split_words(words)) {
        list.push_back({word});
    }
    return {std::move(list)};
}

Assignment maps_assignment(const std::string& maps) {
    return {"--maps " + maps, "image.maps", list_value(maps)};
}

std::vector<Assignment> assignments_of(const RunArguments& arguments) {
    std::vector<Assignment> assignments;
    for (const std::string& set : arguments.sets) {
        assignments.push_back(read_set_argument(set));
    }
    if (arguments.size) {
        assignments.push_back(
            {"--size " + *arguments.size, "image.size", size_value(*arguments.size)});
    }
    if (arguments.seed) {
        assignments.push_back(
            {"--seed " + *arguments.seed, "foam.seed", read_value(*arguments.seed)});
    }
    return assignments;
}

Preset preset_of(const RunArguments& arguments, const std::vector<Assignment>& more) {
    check_is_no_cache(arguments.preset);
    LoadedPreset loaded = load_with_assignments(arguments.preset);
    return assigned(
        std::move(loaded.preset),
        is_preset_path(arguments.preset) ? loaded.assignments : std::vector<Assignment>(),
        arguments,
        more);
}

Preset changed(Preset preset, const RunArguments& arguments, const std::vector<Assignment>& more) {
    return assigned(std::move(preset), {}, arguments, more);
}

void note_keys_without_maps(const RunArguments& arguments, const Preset& preset) {
    if (arguments.quiet || arguments.profile || FilePattern(preset).is_vector()) {
        return;
    }
    for (const std::string& line : keys_without_maps(preset, assignments_of(arguments))) {
        print_stderr("foamtex: note: {}", line);
    }
}

std::vector<int> frames_of(const RunArguments& arguments, const Preset& preset) {
    return arguments.frames ? parse_frame_range(*arguments.frames) : frames_to(preset.frames.count);
}

Verbosity verbosity_of(const RunArguments& arguments) {
    if (arguments.quiet) {
        return Verbosity::Quiet;
    }
    return arguments.verbose ? Verbosity::Verbose : Verbosity::Normal;
}

ProgressOptions progress_options(const RunArguments& arguments, std::size_t frames) {
    ProgressOptions options = progress_options(arguments.quiet, arguments.progress);
    options.verbosity = verbosity_of(arguments);
    options.frames = static_cast<int>(frames);
    return options;
}

}  // namespace foam::texgen
