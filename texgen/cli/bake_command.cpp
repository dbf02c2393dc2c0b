#include "texgen/bake/bake.h"
#include "texgen/bake/file_pattern.h"
#include "texgen/bake/frame_range.h"
#include "texgen/cli/command.h"
#include "texgen/cli/progress.h"
#include "texgen/preset/assignment.h"
#include "texgen/preset/preset_io.h"
#include "texgen/preset/shipped_presets.h"

#include <CLI/CLI.hpp>
#include <fmt/core.h>

#include <cstddef>
#include <memory>
#include <numeric>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace foam::texgen {

namespace {

constexpr int kMostThreads = 1024;

constexpr const char* kExamples = R"(Examples:
  foamtex bake sea_foam
  foamtex bake sea_foam --size 2048 --seed 7 --out 'foam/{map}.####.png'
  foamtex bake my.toml --frames 1-120x2 --set albedo.colormap=magma
Keys for --set: foamtex presets keys)";

/// The command line as it was given, not yet checked against the preset's limits.
struct BakeArguments {
    std::string preset;
    std::vector<std::string> sets;
    std::optional<std::string> frames;
    std::optional<std::string> size;
    std::optional<std::string> maps;
    std::optional<std::string> out;
    std::optional<std::string> seed;
    int threads = 0;
    bool quiet = false;
    bool verbose = false;
};

/// "W" or "WxH" as [W, H]; what is no number is left for the schema to refuse.
Value size_value(const std::string& size) {
    const std::size_t x = size.find('x');
    const std::string width = size.substr(0, x);
    const std::string height = x == std::string::npos ? width : size.substr(x + 1);
    return {Value::List{read_value(width), read_value(height)}};
}

/// "a,b" as ["a", "b"].
Value list_value(const std::string& words) {
    Value::List list;
    for (const std::string& word : CLI::detail::split(words, ',')) {
        list.push_back({word});
    }
    return {std::move(list)};
}

/// The options that stand for a key come after the `--set`s, and so win.
std::vector<Assignment> assignments_of(const BakeArguments& arguments) {
    std::vector<Assignment> assignments;
    for (const std::string& set : arguments.sets) {
        assignments.push_back(read_set_argument(set));
    }
    if (arguments.size) {
        assignments.push_back(
            {"--size " + *arguments.size, "image.size", size_value(*arguments.size)});
    }
    if (arguments.maps) {
        assignments.push_back(
            {"--maps " + *arguments.maps, "image.maps", list_value(*arguments.maps)});
    }
    if (arguments.seed) {
        assignments.push_back(
            {"--seed " + *arguments.seed, "foam.seed", read_value(*arguments.seed)});
    }
    if (arguments.out) {
        assignments.push_back({"--out " + *arguments.out, "output.pattern", {*arguments.out}});
    }
    return assignments;
}

Preset preset_of(const BakeArguments& arguments) {
    Preset preset = load_preset(arguments.preset);
    assign(preset, assignments_of(arguments));
    return preset;
}

/// Those of --frames, which may go beyond the preset's own, or all of the preset.
std::vector<int> frames_of(const BakeArguments& arguments, const Preset& preset) {
    if (arguments.frames) {
        return parse_frame_range(*arguments.frames);
    }
    std::vector<int> frames(static_cast<std::size_t>(preset.frames.count));
    std::iota(frames.begin(), frames.end(), 1);
    return frames;
}

Verbosity verbosity_of(const BakeArguments& arguments) {
    if (arguments.quiet) {
        return Verbosity::Quiet;
    }
    return arguments.verbose ? Verbosity::Verbose : Verbosity::Normal;
}

/// One line a map: the file, or the sequence and its frames, as image viewers take them.
void print_written(const Preset& preset,
                   const FilePattern& pattern,
                   const std::vector<int>& frames) {
    for (const std::string& map : preset.image.maps) {
        if (frames.size() == 1) {
            fmt::print("{}\n", pattern.path(preset.name, map, frames.front()).string());
        } else {
            fmt::print("{} {}\n", pattern.sequence(preset.name, map), format_frame_range(frames));
        }
    }
}

ExitCode run_bake(const BakeArguments& arguments) {
    const Preset preset = preset_of(arguments);
    const BakeOptions options{.frames = frames_of(arguments, preset), .threads = arguments.threads};
    const FilePattern pattern(preset.output.pattern);
    pattern.check_distinct(options.frames.size(), preset.image.maps.size());

    const Verbosity verbosity = verbosity_of(arguments);
    const BakeSummary summary = bake(preset, options, progress_reporter(verbosity));
    if (summary.status == BakeStatus::NoEquilibrium) {
        fmt::print(
            stderr, "foamtex: frame {}: the foam found no equilibrium\n", summary.failed_frame);
        return ExitCode::NoEquilibrium;
    }
    if (verbosity != Verbosity::Quiet) {
        print_written(preset, pattern, options.frames);
    }
    return ExitCode::Success;
}

void add_key_options(CLI::App& command, BakeArguments& arguments) {
    command.add_option("PRESET", arguments.preset, "Name of a shipped preset, or a .toml file")
        ->required()
        ->option_text(" ");
    command.add_option("--set", arguments.sets, "Change one key of the preset; may be repeated")
        ->allow_extra_args(false)
        ->option_text("KEY=VALUE");
    command.add_option("--frames", arguments.frames, "As 5, 1-10, 1-10x2, 1-10y3 or 1-3,7")
        ->option_text("RANGE");
    command.add_option("--size", arguments.size, "Image size in pixels")->option_text("W[xH]");
    command.add_option("--maps", arguments.maps, "Maps to draw, with commas")->option_text("A,B");
    command.add_option("--seed", arguments.seed, "Another foam of the same kind")->option_text("N");
    command.add_option("--out", arguments.out, "File names; {preset} {map} #### are filled in")
        ->option_text("PATTERN");
}

void add_run_options(CLI::App& command, BakeArguments& arguments) {
    command.add_option("--threads", arguments.threads, "0: one per hardware thread (the default)")
        ->check(CLI::Range(0, kMostThreads))
        ->option_text("N");
    CLI::Option* quiet =
        command.add_flag("-q,--quiet", arguments.quiet, "Say nothing but errors")->option_text(" ");
    command.add_flag("-v,--verbose", arguments.verbose, "Say a line per frame")
        ->excludes(quiet)
        ->option_text(" ");
}

}  // namespace

void add_bake_command(CLI::App& app, Action& action) {
    CLI::App* command = app.add_subcommand("bake", "Bake the frames of a preset into image files");
    const auto arguments = std::make_shared<BakeArguments>();
    add_key_options(*command, *arguments);
    add_run_options(*command, *arguments);
    command->footer(kExamples);
    command->callback(
        [&action, arguments] { action = [arguments] { return run_bake(*arguments); }; });
}

}  // namespace foam::texgen
