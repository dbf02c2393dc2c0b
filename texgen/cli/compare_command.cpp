// SPDX-License-Identifier: Apache-2.0

#include "core/files/file_io.h"
#include "core/files/shown_text.h"
#include "texgen/cli/command.h"
#include "texgen/cli/options.h"
#include "texgen/cli/standard_error.h"
#include "texgen/cli/standard_output.h"
#include "texgen/image/format.h"
#include "texgen/maps/all_maps.h"
#include "texgen/verify/compare_images.h"
#include "texgen/verify/comparison_report.h"
#include "texgen/verify/limit_keys.h"
#include "texgen/verify/tolerances.h"

#include <CLI/CLI.hpp>
#include <fmt/core.h>

#include <algorithm>
#include <cstdio>
#include <memory>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace foam::texgen {

namespace {

constexpr const char* kCompareExamples = R"(Examples:
  foamtex compare golden.png out/sea_foam_albedo.0001.png
  foamtex compare 'old/a.####.exr' 'new/a.####.exr' --warn 1e-4 --fail 1e-3
  foamtex compare golden/ out/ --tolerances golden/tolerances.toml
  foamtex compare golden/manifest.json out/manifest.json --fail 0.01 --fail-pixels 1
  foamtex compare a.png b.png --fail-angle 0.5 --hard-fail 0.8 --fail-percent 0.001
Samples of a PNG, DDS or KTX2 are compared as numbers from 0 to 1, samples of an EXR as stored. The
difference of a pixel is the largest difference of its samples. In folders, manifests and sequences
without --frames, an image that exists only in A or only in B is a failure. A file of tolerances has
a table of limits per map, such as [normal], and a table [default] for all other maps. Its keys are
the names of the options with _ in place of -, such as fail_percent. Options override the file.
Exit codes: 0 same, 1 warning, 2 failure, 3 different size or channels, 4 unreadable,
  5 an output could not be written, 64 bad command line or tolerances, 70 internal failure)";

/// A limit that the command line gives.
struct GivenLimit {
    const Key<CompareLimits>* key;
    Value value;
};

struct CompareArguments {
    std::string a;
    std::string b;
    std::optional<std::string> frames;
    std::optional<std::string> tolerances;
    std::vector<GivenLimit> limits;
    CompareOptions options;
    bool quiet = false;
    bool json = false;
};

/// Returns the placeholder that the help shows for the value of a limit.
const char* placeholder_of(const KeyInfo& key) {
    if (key.path.ends_with("percentile")) {
        return "P=T";
    }
    if (key.path.ends_with("percent")) {
        return "P";
    }
    return key.path.ends_with("pixels") ? "N" : "T";
}

/// Adds the option of a limit. A value that is not allowed is an error of the command line.
void add_limit_option(CLI::App& command,
                      const Key<CompareLimits>& key,
                      std::vector<GivenLimit>& limits) {
    const auto take = [&key, &limits](const std::string& text) {
        CompareLimits ignored;
        limits.push_back({&key, value_of_argument(text)});
        if (!key.read(limits.back().value, ignored)) {
            throw CLI::ValidationError(option_name(key),
                                       fmt::format("'{}' must be {}", text, key.allowed));
        }
    };
    command
        .add_option_function<std::string>(
            option_name(key),
            take,
            fmt::format("{}: {}", is_warning_key(key) ? "Warning" : "Failure", key.meaning))
        ->option_text(placeholder_of(key));
}

/// Returns the options of the comparison. The limits of the command line override the limits that
/// the file of tolerances has for a map. Throws std::invalid_argument for an unknown map, and the
/// exceptions of read_tolerances.
CompareOptions options_of(const CompareArguments& arguments) {
    CompareOptions options = arguments.options;
    if (!options.map.empty()) {
        find_map(options.map);
    }
    const Tolerances tolerances =
        arguments.tolerances ? read_tolerances(*arguments.tolerances) : Tolerances();
    options.limits_of = [tolerances, given = arguments.limits](std::string_view map) {
        CompareLimits limits = tolerances.limits_of(map);
        for (const GivenLimit& limit : given) {
            limit.key->read(limit.value, limits);
        }
        return limits;
    };
    return options;
}

/// Throws InputError if an image is unreadable.
void check_readable(std::span<const ComparedImage> images) {
    const auto is_unreadable = [](const ComparedImage& image) {
        return image.verdict == Verdict::Unreadable;
    };
    const auto count = std::ranges::count_if(images, is_unreadable);
    if (count > 0) {
        throw InputError(
            std::ranges::find_if(images, is_unreadable)->error +
            (count > 1 ? fmt::format(" ({} of {} images are unreadable)", count, images.size())
                       : ""));
    }
}

/// Prints a note on stderr if a limit of angles on the command line applies to none of the images.
void note_unused_angle(std::span<const GivenLimit> limits, std::span<const ComparedImage> images) {
    const auto angle = std::ranges::find_if(
        limits, [](const GivenLimit& limit) { return is_angle_key(*limit.key); });
    if (angle != limits.end() && std::ranges::none_of(images, [](const ComparedImage& image) {
            return image.found.angle.has_value();
        })) {
        print_stderr(
            "foamtex: note: {} has no effect, because no image is known to be a normal map; if the "
            "images are normal maps, add --map normal",
            option_name(*angle->key));
    }
}

/// Compares all pairs and returns the worst verdict as the exit code.
ExitCode run_compare(const CompareArguments& arguments) {
    const CompareOptions options = options_of(arguments);
    const std::vector<ImagePair> pairs = image_pairs(arguments.a, arguments.b, arguments.frames);
    if (options.difference && pairs.size() > 1) {
        throw std::invalid_argument("--diff is only for a single pair of images");
    }
    if (options.difference && options.difference->extension() != ".png") {
        throw std::invalid_argument(
            fmt::format("--diff: the name '{}' must end in .png", options.difference->string()));
    }
    const bool prints_lines = !arguments.quiet && !arguments.json;
    std::vector<ComparedImage> images;
    for (const ImagePair& pair : pairs) {
        std::vector<ComparedImage> compared = compare_pair(pair, options);
        for (ComparedImage& image : compared) {
            write_stdout(prints_lines ? shown_text(to_line(image)) + "\n" : "");
            images.push_back(std::move(image));
        }
    }
    if (prints_lines && images.size() > 1) {
        write_stdout(shown_lines(summary_of(images)));
    }
    if (arguments.json) {
        write_stdout(to_json(images));
    }
    note_unused_angle(arguments.limits, images);
    check_readable(images);
    return static_cast<ExitCode>(worst_verdict(images));
}

}  // namespace

void add_compare_command(CLI::App& app, Action& action) {
    CLI::App* command =
        app.add_subcommand("compare", "Compare images, sequences, or folders of images");
    const auto arguments = std::make_shared<CompareArguments>();
    command
        ->add_option("A",
                     arguments->a,
                     "The reference: an image (" + format_suffixes() +
                         "), a sequence (####), a folder, or a manifest.json")
        ->required()
        ->option_text(" ");
    command->add_option("B", arguments->b, "The candidate to compare with A, of the same kind as A")
        ->required()
        ->option_text(" ");
    for (const Key<CompareLimits>& key : limit_keys()) {
        add_limit_option(*command, key, arguments->limits);
    }
    command->add_option("--tolerances", arguments->tolerances, "TOML file with limits for each map")
        ->option_text("FILE");
    command
        ->add_option("--map",
                     arguments->options.map,
                     "Map of the images; the default is given by the EXR layer, the manifest or "
                     "the metadata of the image")
        ->option_text("MAP");
    add_frames_option(
        *command, arguments->frames, "Frames of both sequences; by default all existing frames");
    command
        ->add_option("--diff", arguments->options.difference, "Write the differences as a gray PNG")
        ->excludes("--frames")
        ->option_text("FILE");
    add_quiet_option(
        *command,
        arguments->quiet,
        "Print only errors, notes and, with --json, the report; the exit code is the result");
    add_json_option(*command, arguments->json);
    command->footer(kCompareExamples);
    command->callback(
        [&action, arguments] { action = [arguments] { return run_compare(*arguments); }; });
}

}  // namespace foam::texgen
