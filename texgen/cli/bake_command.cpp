#include "texgen/bake/bake.h"
#include "texgen/bake/file_pattern.h"
#include "texgen/bake/frame_range.h"
#include "texgen/cli/command.h"
#include "texgen/cli/report.h"
#include "texgen/cli/run_arguments.h"
#include "texgen/manifest/recorded_bake.h"
#include "texgen/preset/assignment.h"
#include "texgen/stats/files.h"
#include "texgen/stats/record.h"

#include <CLI/CLI.hpp>
#include <fmt/core.h>

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace foam::texgen {

namespace {

constexpr const char* kExamples = R"(Examples:
  foamtex bake sea_foam
  foamtex bake sea_foam --size 2048 --seed 7 --out 'foam/{map}.####.png'
  foamtex bake my.toml --frames 1-120x2 --set albedo.colormap=magma
  foamtex bake sea_foam --maps albedo,film --out 'out/layers.####.exr'
Keys for --set: foamtex presets keys)";

struct BakeArguments {
    RunArguments run;
    std::optional<std::string> maps;
    std::optional<std::string> normal_y;
    std::optional<std::string> out;
    bool stats = false;
};

std::vector<Assignment> image_assignments_of(const BakeArguments& arguments) {
    std::vector<Assignment> assignments;
    if (arguments.maps) {
        assignments.push_back(maps_assignment(*arguments.maps));
    }
    if (arguments.normal_y) {
        assignments.push_back(
            {"--normal-y " + *arguments.normal_y, "normal.y", {*arguments.normal_y}});
    }
    if (arguments.out) {
        assignments.push_back({"--out " + *arguments.out, "output.pattern", {*arguments.out}});
    }
    return assignments;
}

/// One line a map, or one for all: the file, or the sequence and its frames, as image viewers take
/// them.
void print_images(const Preset& preset,
                  const FilePattern& pattern,
                  const std::vector<int>& frames) {
    for (const std::string& map : preset.image.maps) {
        if (frames.size() == 1) {
            fmt::print("{}\n", pattern.path(preset.name, map, frames.front()).string());
        } else {
            fmt::print("{} {}\n", pattern.sequence(preset.name, map), format_frame_range(frames));
        }
        if (pattern.joins_maps()) {
            return;
        }
    }
}

std::filesystem::path statistics_folder(const Preset& preset, const FilePattern& pattern) {
    const std::filesystem::path image = pattern.path(preset.name, preset.image.maps.front(), 1);
    return image.parent_path() / (preset.name + "_stats");
}

ExitCode run_bake(const BakeArguments& arguments) {
    const Preset preset = preset_of(arguments.run, image_assignments_of(arguments));
    const BakeOptions options{.frames = frames_of(arguments.run, preset),
                              .threads = arguments.run.threads};
    const FilePattern pattern(preset.output.pattern);
    pattern.check_distinct(options.frames.size(), preset.image.maps.size());

    const Verbosity verbosity = verbosity_of(arguments.run);
    Recorder recorder(preset);
    const BakeSummary summary =
        bake_recorded(preset,
                      options,
                      {.on_progress = progress_reporter(verbosity),
                       .on_frame = arguments.stats ? recorder.visitor() : FrameVisitor()});
    std::vector<std::filesystem::path> tables_and_charts;
    if (arguments.stats) {
        tables_and_charts = write_statistics(recorder.run(), statistics_folder(preset, pattern));
    }
    if (summary.outcome.status != RunStatus::Complete) {
        return report_failure(summary.outcome);
    }
    if (verbosity != Verbosity::Quiet) {
        print_images(preset, pattern, options.frames);
        print_files(tables_and_charts);
    }
    return ExitCode::Success;
}

void add_image_options(CLI::App& command, BakeArguments& arguments) {
    command.add_option("--maps", arguments.maps, "Maps to draw, with commas")->option_text("A,B");
    command.add_option("--normal-y", arguments.normal_y, "Green of normals: gl (up), dx (down)")
        ->option_text("gl|dx");
    command
        .add_option(
            "--out", arguments.out, "File names, .png or .exr; {preset} {map} #### are filled in")
        ->option_text("PATTERN");
    command.add_flag("--stats", arguments.stats, "Statistics too, in {preset}_stats beside")
        ->option_text(" ");
}

}  // namespace

void add_bake_command(CLI::App& app, Action& action) {
    CLI::App* command = app.add_subcommand("bake", "Bake the frames of a preset into image files");
    const auto arguments = std::make_shared<BakeArguments>();
    add_preset_options(*command, arguments->run);
    add_image_options(*command, *arguments);
    add_run_options(*command, arguments->run);
    command->footer(kExamples);
    command->callback(
        [&action, arguments] { action = [arguments] { return run_bake(*arguments); }; });
}

}  // namespace foam::texgen
