// SPDX-License-Identifier: Apache-2.0

#include "texgen/bake/bake_estimate.h"
#include "texgen/bake/fitted_ranges.h"
#include "texgen/cache/shared_simulation.h"
#include "texgen/cli/command.h"
#include "texgen/cli/image_run.h"
#include "texgen/cli/image_sizes.h"
#include "texgen/cli/report.h"
#include "texgen/cli/run_arguments.h"
#include "texgen/cli/watch.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <memory>
#include <system_error>
#include <utility>
#include <vector>

namespace foam::texgen {

namespace {

constexpr const char* kBakeExamples = R"(Examples:
  foamtex bake sea_foam --size 2048,512 --seed 7 --out 'foam/{size}_{map}.####.png'
  foamtex bake lava --for unreal --scene usda
  foamtex bake maze --frames 1 --out maze.svg --set vector.width_mm=200
A loop has frames.count frames; "foamtex presets keys" lists this and all other keys for --set.
--progress json prints JSON lines with phase, done, total (in units of the phase), seconds, seconds_left
(of the phase), frame, bubbles and, in a loop, cycle and measure (closing error in bubble diameters).)";

struct BakeArguments {
    RunArguments run;
    ImageArguments images;
};

/// Returns the frames that the simulation shared by several sizes must compute.
std::vector<int> simulated_frames(const std::vector<Preset>& presets,
                                  const std::vector<int>& frames,
                                  bool dry_run) {
    if (dry_run) {
        const std::size_t count = std::min(frames.size(), kEstimatedFrames);
        return {frames.begin(), frames.begin() + static_cast<std::ptrdiff_t>(count)};
    }
    return frames_to_simulate(presets, frames);
}

/// Warns if the disk of the folder for temporary files has too little space for the states of the
/// given frames, which SharedSimulation stores there.
void warn_of_full_temporary_disk(const Preset& preset, const std::vector<int>& frames) {
    std::error_code error;
    const std::filesystem::path folder = std::filesystem::temp_directory_path(error);
    if (!error) {
        warn_of_full_disk(estimated_cache_size(preset, frames, folder), folder);
    }
}

/// Draws each of the presets, which differ in the size of their images.
ExitCode bake_sizes(const std::vector<Preset>& presets,
                    const std::vector<int>& frames,
                    const BakeArguments& arguments) {
    const bool is_dry = arguments.images.dry_run;
    const bool is_single = presets.size() == 1;
    SharedSimulation shared(
        presets.front(), simulated_frames(presets, frames, is_dry), arguments.run.threads);
    std::vector<ImageRun> runs;
    for (const Preset& preset : presets) {
        BakeOptions options{.frames = frames, .threads = arguments.run.threads};
        // A single size needs no shared simulation. In a dry run, the first size does not use it
        // either, so that its estimate measures the time of a simulation.
        if (!is_single && !(is_dry && runs.empty())) {
            options.source = shared.source(preset);
        }
        runs.push_back({preset, std::move(options)});
    }
    const bool stores_states = !is_single || has_automatic_ranges(presets.front());
    if (stores_states && !is_dry && !arguments.run.quiet) {
        warn_of_full_temporary_disk(presets.front(), frames_to_simulate(presets, frames));
    }
    return run_images(runs, arguments.images, progress_options(arguments.run, frames.size()));
}

ExitCode bake_once(const BakeArguments& arguments) {
    const std::vector<Preset> presets =
        presets_of_sizes(arguments.run, [&](const RunArguments& run) {
            Preset preset = preset_of(run, assignments_of(arguments.images));
            return with_sheets_placed(std::move(preset), run, arguments.images);
        });
    note_keys_without_maps(arguments.run, presets.front());
    const std::vector<int> frames = frames_of(arguments.run, presets.front());
    const ExitCode code = bake_sizes(presets, frames, arguments);
    if (code == ExitCode::Success && !arguments.run.quiet && !arguments.images.json) {
        note_open_loop(presets.front(), frames);
        warn_of_late_events(presets.front(), frames);
    }
    return code;
}

ExitCode run_bake(const BakeArguments& arguments) {
    if (arguments.images.watch) {
        run_watching(arguments.run, [&] { bake_once(arguments); });
    }
    return bake_once(arguments);
}

}  // namespace

void add_bake_command(CLI::App& app, Action& action) {
    CLI::App* command = app.add_subcommand("bake", "Bake the frames of a preset into image files");
    const auto arguments = std::make_shared<BakeArguments>();
    add_preset_options(*command, arguments->run);
    add_profile_option(*command, arguments->run);
    add_image_options(*command, arguments->images);
    describe_several_sizes(*command);
    add_watch_option(*command, arguments->images.watch);
    add_run_options(*command, arguments->run);
    command->footer(kBakeExamples);
    command->callback(
        [&action, arguments] { action = [arguments] { return run_bake(*arguments); }; });
}

}  // namespace foam::texgen
