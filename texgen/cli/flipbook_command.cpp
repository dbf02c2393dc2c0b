// SPDX-License-Identifier: Apache-2.0

#include "texgen/bake/frame_range.h"
#include "texgen/cli/command.h"
#include "texgen/cli/image_folder.h"
#include "texgen/cli/json_report.h"
#include "texgen/cli/options.h"
#include "texgen/cli/progress.h"
#include "texgen/cli/report.h"
#include "texgen/cli/standard_error.h"
#include "texgen/sheet/flipbook.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace foam::texgen {

namespace {

constexpr const char* kFlipbookExamples = R"(Examples:
  foamtex bake sea_foam --size 256 --maps albedo,normal
  foamtex flipbook out                          one sheet per map, and sea_foam_sheet.json
  foamtex flipbook out --maps albedo --gutter 4 --columns 6
  foamtex flipbook out --strip --frames 1-48x2  for texture arrays
  foamtex flipbook out --dds                    texture arrays, as games load them
  foamtex flipbook out --out sheets             into another folder
Without --preset, --size and --seed, the newest images of the folder are used.)";

// The largest width and height, in pixels, of a texture that graphics hardware usually supports.
constexpr int kMaxTextureSide = 16384;
constexpr int kMaxGutter = 1024;  // largest allowed value of --gutter, in pixels

struct FlipbookArguments {
    std::filesystem::path given;  // a folder, or the manifest in it
    SetArguments set;
    std::optional<std::string> maps;
    std::optional<std::string> frames;
    std::optional<std::filesystem::path> out;
    FlipbookOptions options;
    bool quiet = false;
    bool json = false;
    std::string progress;
};

void warn_of_size(const FlipbookArguments& arguments, const SheetLayout& layout) {
    if (!arguments.options.array_suffix.empty()) {
        return;
    }
    if (layout.width() > kMaxTextureSide || layout.height() > kMaxTextureSide) {
        print_stderr(
            "foamtex: warning: the sheet is {} x {} pixels; graphics hardware usually supports at "
            "most {} per side",
            layout.width(),
            layout.height(),
            kMaxTextureSide);
    }
}

/// Prints the JSON object of the command. It contains the paths of the sheets and of the file that
/// describes their layout.
void print_report(const BakedSet& set, const std::vector<int>& frames, const Flipbook& flipbook) {
    Json report = json_report();
    report["preset"] = set.preset;
    report["frames"] = format_frame_range(frames);
    report["layout"] = flipbook.files.back().string();
    report["files"] = path_list(std::span(flipbook.files).first(flipbook.files.size() - 1));
    print_json(report);
}

ExitCode run_flipbook(const FlipbookArguments& arguments) {
    const std::filesystem::path& given = arguments.given;
    const Manifest manifest = read_image_manifest(given);
    const BakedSet& set =
        chosen_set(manifest, choice_of(arguments.set), given, arguments.quiet || arguments.json);
    const std::filesystem::path folder =
        std::filesystem::is_directory(given) ? given : given.parent_path();
    FlipbookOptions options = arguments.options;
    if (arguments.maps) {
        options.maps = split_words(*arguments.maps);
    }
    options.frames = arguments.frames ? parse_frame_range(*arguments.frames) : set.frames();
    const Flipbook flipbook = [&] {
        ProgressReporter reporter(progress_options(arguments.quiet, arguments.progress));
        return write_flipbook(
            set, folder, options, arguments.out.value_or(folder), reporter.callback());
    }();
    warn_of_size(arguments, flipbook.layout);
    if (!arguments.quiet) {
        report_earlier_sheets(flipbook);
    }
    if (arguments.json) {
        print_report(set, options.frames, flipbook);
    } else if (!arguments.quiet) {
        print_files(flipbook.files);
    }
    return ExitCode::Success;
}

void add_choices(CLI::App& command, FlipbookArguments& arguments) {
    command.add_option("DIR", arguments.given, "Folder with a manifest.json, or the file itself")
        ->required()
        ->option_text(" ");
    add_set_options(command, arguments.set);
    add_maps_option(command, arguments.maps, "Maps, separated by commas (default: all)");
    add_frames_option(command, arguments.frames, "Frames (default: all)");
}

void add_layout(CLI::App& command, FlipbookArguments& arguments) {
    CLI::Option* columns = command
                               .add_option("--columns",
                                           arguments.options.columns,
                                           "Frames per row (default: a nearly square sheet)")
                               ->check(CLI::Range(1, kLastFrame))
                               ->option_text("N");
    CLI::Option* gutter =
        command
            .add_option(
                "--gutter",
                arguments.options.gutter,
                "Width in pixels of a border around each frame (default: 0); the border "
                "periodically continues a frame that tiles, and repeats the edge pixels of any "
                "other frame")
            ->check(CLI::Range(0, kMaxGutter))
            ->option_text("PX");
    CLI::Option* strip =
        command.add_flag("--strip", arguments.options.strip, "Use one column, for texture arrays")
            ->excludes(columns)
            ->excludes(gutter)
            ->option_text(" ");
    const auto add_array = [&](const char* name, const char* suffix) {
        return command
            .add_flag_callback(
                name,
                [&arguments, suffix] { arguments.options.array_suffix = suffix; },
                fmt::format("Instead of sheets, write array textures ({}) with mip levels", suffix))
            ->excludes(columns)
            ->excludes(gutter)
            ->excludes(strip)
            ->option_text(" ");
    };
    CLI::Option* const dds = add_array("--dds", ".dds");
    add_array("--ktx2", ".ktx2")->excludes(dds);
    add_out_folder_option(command, arguments.out, "Folder for the sheets (default: DIR)");
    CLI::Option* const quiet = add_quiet_option(
        command, arguments.quiet, "Print only errors, warnings and, with --json, the report");
    add_progress_option(command, arguments.progress)->excludes(quiet);
    add_json_option(command, arguments.json);
}

}  // namespace

void add_flipbook_command(CLI::App& app, Action& action) {
    CLI::App* command =
        app.add_subcommand("flipbook", "Join the frames of a bake into sprite sheets");
    const auto arguments = std::make_shared<FlipbookArguments>();
    add_choices(*command, *arguments);
    add_layout(*command, *arguments);
    command->footer(kFlipbookExamples);
    command->callback(
        [&action, arguments] { action = [arguments] { return run_flipbook(*arguments); }; });
}

}  // namespace foam::texgen
