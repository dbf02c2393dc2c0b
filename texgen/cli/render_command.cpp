// SPDX-License-Identifier: Apache-2.0

#include "core/files/file_io.h"
#include "texgen/cache/cache.h"
#include "texgen/cache/cache_files.h"
#include "texgen/cli/command.h"
#include "texgen/cli/image_folder.h"
#include "texgen/cli/image_run.h"
#include "texgen/cli/image_sizes.h"
#include "texgen/cli/report.h"
#include "texgen/cli/run_arguments.h"
#include "texgen/preset/simulation_keys.h"

#include <CLI/CLI.hpp>
#include <fmt/core.h>

#include <filesystem>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace foam::texgen {

namespace {

constexpr const char* kRenderExamples = R"(Examples:
  foamtex render foam --frames 1-100x2
  foamtex render foam --size 4096 --maps albedo,height,normal --out 'out/{map}.####.exr'
If the cache contains all frames of the animation, the images are identical to those of a bake. Keys
of images, output, drawings, meshes and maps can be set, but the aspect ratio of a torus cannot be
changed. For a patch in which no event has a position, keys of the camera can also be set.)";

struct RenderArguments {
    RunArguments run;
    ImageArguments images;
};

/// Throws InputError if the path is a folder that is not a cache, or the name of a preset. For a
/// preset, the message says how to make a cache. For any other path, the class Cache reports the
/// error.
void check_is_cache(const std::string& path) {
    if (std::filesystem::is_directory(path) && !is_cache(path)) {
        throw InputError(fmt::format(
            "'{}' has no {}: it is not a folder of simulated states", path, kCacheName));
    }
    if (is_preset_name(path)) {
        throw InputError(fmt::format(
            "'{0}' is a preset, not a folder of simulated states; 'foamtex simulate {0} "
            "--cache FOLDER' makes one, and 'foamtex bake {0}' draws the preset",
            path));
    }
}

ExitCode run_render(const RenderArguments& arguments) {
    check_is_cache(arguments.run.preset);
    const Cache cache(arguments.run.preset);
    const CacheInfo& info = cache.info();
    const std::vector<Preset> presets =
        presets_of_sizes(arguments.run, [&](const RunArguments& run) {
            Preset preset = changed(info.preset, run, assignments_of(arguments.images));
            check_same_simulation(info.preset, preset);
            return with_sheets_placed(std::move(preset), run, arguments.images);
        });
    if (!arguments.run.quiet) {
        note_other_version(info, arguments.run.preset);
    }
    note_keys_without_maps(arguments.run, presets.front());
    const std::vector<int> frames =
        arguments.run.frames ? frames_of(arguments.run, presets.front()) : info.frames;
    // A job of a farm draws a few of many frames, and need not read the states of the others.
    const SkippedEfforts skipped =
        arguments.images.stats ? SkippedEfforts::Counted : SkippedEfforts::Ignored;
    std::vector<ImageRun> runs;
    runs.reserve(presets.size());
    for (const Preset& preset : presets) {
        runs.push_back({preset,
                        {.frames = frames,
                         .threads = arguments.run.threads,
                         .source = cache.frames_of(preset, skipped),
                         .sequence = info.frames,
                         .cache = arguments.run.preset}});
    }
    return run_images(runs, arguments.images, progress_options(arguments.run, frames.size()));
}

}  // namespace

void add_render_command(CLI::App& app, Action& action) {
    CLI::App* command = app.add_subcommand("render", "Draw frames from simulated states");
    const auto arguments = std::make_shared<RenderArguments>();
    command->add_option("CACHE", arguments->run.preset, "Folder that foamtex simulate has written")
        ->required()
        ->option_text(" ");
    add_frame_options(*command, arguments->run);
    add_profile_option(*command, arguments->run);
    add_image_options(*command, arguments->images);
    describe_several_sizes(*command);
    add_run_options(*command, arguments->run);
    command->footer(kRenderExamples);
    command->callback(
        [&action, arguments] { action = [arguments] { return run_render(*arguments); }; });
}

}  // namespace foam::texgen
