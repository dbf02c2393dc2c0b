// SPDX-License-Identifier: Apache-2.0

#include "texgen/bake/file_pattern.h"
#include "texgen/bake/frame_range.h"
#include "texgen/cli/command.h"
#include "texgen/cli/json_report.h"
#include "texgen/cli/options.h"
#include "texgen/image/compare.h"
#include "texgen/image/format.h"
#include "texgen/image/png.h"

#include <CLI/CLI.hpp>
#include <fmt/core.h>

#include <algorithm>
#include <filesystem>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace foam::texgen {

namespace {

constexpr const char* kCompareExamples = R"(Examples:
  foamtex compare golden.png out/sea_foam_albedo.0001.png
  foamtex compare 'old/a.####.exr' 'new/a.####.exr' --frames 1-48 --warn 1e-4 --fail 1e-3
Samples of a PNG are compared as numbers from 0 to 1, samples of an EXR as stored.
Exit codes: 0 same, 1 warning, 2 failure, 3 different size or channels, 4 unreadable)";

struct CompareArguments {
    std::string a;
    std::string b;
    std::optional<std::string> frames;
    std::optional<std::string> difference;
    CompareLimits limits;
    bool quiet = false;
    bool json = false;
};

using Paths = std::pair<std::filesystem::path, std::filesystem::path>;

/// Returns the pairs of images to compare: one pair, or one per frame of --frames. Throws
/// std::invalid_argument if the range or a pattern is malformed, or if there are several frames and
/// a pattern has no frame number.
std::vector<Paths> pairs_of(const CompareArguments& arguments) {
    if (!arguments.frames) {
        return {{arguments.a, arguments.b}};
    }
    const std::vector<int> frames = parse_frame_range(*arguments.frames);
    const FilePattern a(arguments.a);
    const FilePattern b(arguments.b);
    a.check_distinct(frames.size(), 1);
    b.check_distinct(frames.size(), 1);
    std::vector<Paths> pairs;
    pairs.reserve(frames.size());
    for (const int frame : frames) {
        pairs.emplace_back(a.path({}, {}, frame), b.path({}, {}, frame));
    }
    return pairs;
}

/// Returns the value of a verdict in JSON. Programs read these values, so they must not change.
const char* json_value_of(Verdict verdict) {
    switch (verdict) {
        case Verdict::Same:
            return "same";
        case Verdict::Warning:
            return "warning";
        case Verdict::Failure:
            return "failure";
        default:
            return "other size or channels";
    }
}

const char* text_of(Verdict verdict) {
    return verdict == Verdict::DifferentLayout ? "different size or channels"
                                               : json_value_of(verdict);
}

void print_line(const Paths& paths, const Comparison& found) {
    fmt::print("{}: {}", paths.second.string(), text_of(found.verdict));
    if (found.largest > 0.0) {
        fmt::print(
            ", largest difference {:.6g} in {} at {},{}, mean {:.3g}, {} samples above the limits",
            found.largest,
            found.channel,
            found.x,
            found.y,
            found.mean,
            std::max(found.warnings, found.failures));
    }
    fmt::print("\n");
}

Json to_json(const Paths& paths, const Comparison& found) {
    return {{"a", paths.first.string()},
            {"b", paths.second.string()},
            {"verdict", json_value_of(found.verdict)},
            {"largest", number_or_null(found.largest)},
            {"mean", number_or_null(found.mean)},
            {"channel", found.channel},
            {"x", found.x},
            {"y", found.y},
            {"warnings", found.warnings},
            {"failures", found.failures}};
}

Comparison compare_files(const Paths& paths, const CompareArguments& arguments) {
    const Picture a = read_picture(paths.first);
    const Picture b = read_picture(paths.second);
    Comparison found = compare(a, b, arguments.limits);
    if (!arguments.quiet && !arguments.json) {
        print_line(paths, found);
    }
    if (arguments.difference && found.verdict != Verdict::DifferentLayout) {
        write_png(
            *arguments.difference, difference_picture(a, b).view(), {}, {.filter = PngFilter::Up});
    }
    return found;
}

/// Compares all pairs and returns the worst verdict as the exit code.
ExitCode run_compare(const CompareArguments& arguments) {
    Verdict worst = Verdict::Same;
    Json images = Json::array();
    for (const Paths& paths : pairs_of(arguments)) {
        const Comparison found = compare_files(paths, arguments);
        worst = std::max(worst, found.verdict);
        images.push_back(to_json(paths, found));
    }
    if (arguments.json) {
        print_json({{"status", json_value_of(worst)}, {"images", images}});
    }
    return static_cast<ExitCode>(worst);
}

}  // namespace

void add_compare_command(CLI::App& app, Action& action) {
    CLI::App* command = app.add_subcommand("compare", "Compare images, or sequences of images");
    const auto arguments = std::make_shared<CompareArguments>();
    const CLI::Range any_distance(0.0, std::numeric_limits<double>::max());
    command
        ->add_option("A",
                     arguments->a,
                     "An image, " + format_suffixes() +
                         ", or with --frames the file name pattern of a sequence")
        ->required()
        ->option_text(" ");
    command->add_option("B", arguments->b, "The image or sequence that is compared with A")
        ->required()
        ->option_text(" ");
    command
        ->add_option("--fail",
                     arguments->limits.fail,
                     "Difference above which the result is a failure (default 1e-6)")
        ->check(any_distance)
        ->option_text("T");
    command
        ->add_option("--warn",
                     arguments->limits.warn,
                     "Difference above which the result is a warning (default 1e-6)")
        ->check(any_distance)
        ->option_text("T");
    add_frames_option(*command, arguments->frames, "Frames of both sequences");
    command->add_option("--diff", arguments->difference, "Write the differences as a gray PNG")
        ->excludes("--frames")
        ->option_text("FILE");
    add_quiet_option(
        *command, arguments->quiet, "Print only errors, and --json; the exit code is the result");
    add_json_option(*command, arguments->json);
    command->footer(kCompareExamples);
    command->callback(
        [&action, arguments] { action = [arguments] { return run_compare(*arguments); }; });
}

}  // namespace foam::texgen
