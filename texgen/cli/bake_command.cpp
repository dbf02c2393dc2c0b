// SPDX-License-Identifier: Apache-2.0

#include "texgen/cli/command.h"
#include "texgen/cli/image_run.h"
#include "texgen/cli/report.h"
#include "texgen/cli/run_arguments.h"

#include <CLI/CLI.hpp>

#include <memory>

namespace foam::texgen {

namespace {

constexpr const char* kBakeExamples = R"(Examples:
  foamtex bake sea_foam --size 2048 --seed 7 --out 'foam/{map}.####.png'
  foamtex bake lava --for unreal --scene usda
  foamtex bake maze --frames 1 --out maze.svg --set vector.width_mm=200
A loop has frames.count frames; foamtex presets keys lists this and all other keys for --set.
--progress json prints one JSON object per line: phase; done and total, in units of the phase;
seconds since the start; seconds_left of the phase; frame; bubbles; and, in a loop that is closed,
cycle and measure (its closing error in mean bubble diameters).)";

struct BakeArguments {
    RunArguments run;
    ImageArguments images;
};

ExitCode run_bake(const BakeArguments& arguments) {
    const Preset preset = preset_of(arguments.run, assignments_of(arguments.images));
    const BakeOptions options{.frames = frames_of(arguments.run, preset),
                              .threads = arguments.run.threads};
    const ExitCode code = run_images(
        preset, options, arguments.images, progress_options(arguments.run, options.frames.size()));
    if (code == ExitCode::Success && !arguments.run.quiet && !arguments.images.json) {
        note_open_loop(preset, options.frames);
        note_late_events(preset, options.frames);
    }
    return code;
}

}  // namespace

void add_bake_command(CLI::App& app, Action& action) {
    CLI::App* command = app.add_subcommand("bake", "Bake the frames of a preset into image files");
    const auto arguments = std::make_shared<BakeArguments>();
    add_preset_options(*command, arguments->run);
    add_profile_option(*command, arguments->run);
    add_image_options(*command, arguments->images);
    add_run_options(*command, arguments->run);
    command->footer(kBakeExamples);
    command->callback(
        [&action, arguments] { action = [arguments] { return run_bake(*arguments); }; });
}

}  // namespace foam::texgen
