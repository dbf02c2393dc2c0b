// SPDX-License-Identifier: Apache-2.0

#include "core/files/file_io.h"
#include "core/files/scratch_folder.h"
#include "texgen/animation/shown_states.h"
#include "texgen/animation/timeline.h"
#include "texgen/bake/estimated_size.h"
#include "texgen/bake/frame_files.h"
#include "texgen/bake/frame_range.h"
#include "texgen/cli/command.h"
#include "texgen/cli/image_folder.h"
#include "texgen/cli/json_report.h"
#include "texgen/cli/memory_need.h"
#include "texgen/cli/options.h"
#include "texgen/cli/report.h"
#include "texgen/cli/run_arguments.h"
#include "texgen/cli/watch.h"
#include "texgen/manifest/manifest_file.h"
#include "texgen/manifest/recorded_bake.h"
#include "texgen/maps/all_maps.h"
#include "texgen/sheet/preview.h"
#include "texgen/sheet/video.h"

#include <CLI/CLI.hpp>
#include <fmt/core.h>

#include <algorithm>
#include <filesystem>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <system_error>
#include <vector>

namespace foam::texgen {

namespace {

constexpr const char* kPreviewExamples = R"(Examples:
  foamtex preview sea_foam                    bakes the preset and writes previews to out/
  foamtex preview lava --size 512             bakes smaller images, which is faster
  foamtex preview out                         previews the images in the folder out/
  foamtex preview labyrinth --frames 1 --as tiling --set pressure.exaggeration=4
  foamtex preview out --maps albedo,normal --as loop --width 256
  foamtex preview out --as mp4,gif            makes videos; needs ffmpeg
In a folder, the newest images are shown, or the images that --preset, --size and --seed choose.)";

constexpr int kMaxAnimationSize = 4096;

struct PreviewArguments {
    RunArguments run;
    std::string shown_preset;  // --preset: the preset whose images in the folder are shown
    std::optional<std::string> maps;
    std::optional<std::filesystem::path> out;
    std::vector<std::string> kinds;
    int animation_size = PreviewOptions().size;
    bool json = false;
    bool watch = false;
};

PreviewKind kind_of(const std::string& name) {
    const auto* const found = std::ranges::find(kPreviewNames, name);
    return static_cast<PreviewKind>(found - kPreviewNames.begin());
}

PreviewOptions options_of(const PreviewArguments& arguments) {
    PreviewOptions options{.size = arguments.animation_size, .threads = arguments.run.threads};
    if (arguments.maps) {
        options.maps = split_words(*arguments.maps);
    }
    for (const std::string& name : arguments.kinds) {
        options.kinds.push_back(kind_of(name));
    }
    const auto is_video = [](PreviewKind kind) { return kind >= PreviewKind::Mp4; };
    if (std::ranges::any_of(options.kinds, is_video)) {
        check_ffmpeg();  // fails here rather than after a long bake
    }
    return options;
}

/// The name of the preset and the frames that were previewed, and the files that were written.
struct PreviewResult {
    std::string preset;
    std::vector<int> frames;
    std::vector<std::filesystem::path> files = {};
};

void print(const PreviewArguments& arguments, const PreviewResult& result, Json report) {
    if (arguments.json) {
        report["preset"] = result.preset;
        report["frames"] = format_frame_range(result.frames);
        report["files"] = path_list(result.files);
        print_json(report);
    } else if (!arguments.run.quiet) {
        print_files(result.files);
    }
}

ExitCode preview_folder(const PreviewArguments& arguments) {
    const std::filesystem::path folder = arguments.run.preset;
    if (!arguments.run.sets.empty()) {
        throw std::invalid_argument("--set is only allowed with a preset, not with a folder");
    }
    PreviewOptions options = options_of(arguments);
    const Manifest manifest = read_image_manifest(folder);
    const BakedSet& set =
        chosen_set(manifest,
                   choice_of({arguments.shown_preset, arguments.run.size, arguments.run.seed}),
                   folder,
                   arguments.run.quiet || arguments.json);
    options.frames = arguments.run.frames ? parse_frame_range(*arguments.run.frames) : set.frames();
    PreviewResult result{set.preset, options.frames};
    {
        ProgressReporter reporter(progress_options(arguments.run, 0));
        result.files = write_previews(
            set, folder, options, arguments.out.value_or(folder), reporter.callback());
    }
    print(arguments, result, json_report());
    return ExitCode::Success;
}

/// Returns the preset to bake: the preset that the arguments name, with these changes:
/// - Its maps are the maps to preview, by default only the first map of the preset.
/// - It has no packed images.
/// - Its images are PNG files in `folder`, with sRGB primaries.
Preset preset_to_bake(const PreviewArguments& arguments, const std::filesystem::path& folder) {
    std::vector<Assignment> assignments;
    if (arguments.maps) {
        assignments.push_back(maps_assignment(*arguments.maps));
    }
    Preset preset = preset_of(arguments.run, assignments);
    preset.image.maps.resize(arguments.maps ? preset.image.maps.size() : 1);
    preset.output.pack.clear();
    preset.output.pattern = (folder / "{map}.######.png").string();
    preset.output.primaries = Primaries::Srgb;
    return preset;
}

/// Returns true if a frame tiles. Only events can shear a foam that is drawn: in a loop of the kind
/// `shear`, the shear is removed before the foam is drawn.
bool frame_tiles(const Preset& preset, int frame) {
    const int state = shown_states(frame, preset.loop, preset.frames.count).state;
    const double height = preset.image.height;
    return preset.shape.kind == FoamKind::Torus &&
           tiles({.width = static_cast<double>(preset.image.width),
                  .height = height,
                  .shear = height * strain_of_events(preset, state)});
}

/// Throws std::invalid_argument if the previews of a preset are impossible, before anything is
/// simulated.
void check_possible(const PreviewOptions& options, const Preset& preset) {
    const int first = options.frames.front();
    check_tiling(options, frame_tiles(preset, first), first, preset.name);
    for (const std::string& map : preset.image.maps) {
        check_shown_map(map, drawn_traits(find_map(map), preset.maps).kind == MapKind::Id);
    }
}

ExitCode preview_preset(const PreviewArguments& arguments) {
    const ScratchFolder scratch;
    const Preset preset = preset_to_bake(arguments, scratch.path());
    PreviewOptions options = options_of(arguments);
    options.frames = frames_of(arguments.run, preset);
    check_possible(options, preset);
    check_writable(arguments.out.value_or("out"));
    note_keys_without_maps(arguments.run, preset);
    const MemoryNeed need = memory_to_bake(preset, options.frames.size(), arguments.run.threads);
    if (!arguments.run.quiet) {
        warn_of_full_disk(estimated_size(preset, options.frames), scratch.path());
        warn_of_little_memory(need);
    }
    PreviewResult result{preset.name, options.frames};
    const RunOutcome outcome = with_memory(need, [&] {
        ProgressReporter reporter(progress_options(arguments.run, options.frames.size()));
        const BakeSummary summary =
            bake_recorded(preset,
                          {.frames = options.frames, .threads = arguments.run.threads},
                          {.on_progress = reporter.callback()});
        if (summary.outcome.status == RunStatus::Complete) {
            const Manifest manifest = read_manifest(scratch.path());
            result.files = write_previews(manifest.sets.front(),
                                          scratch.path(),
                                          options,
                                          arguments.out.value_or("out"),
                                          reporter.callback());
        }
        return summary.outcome;
    });
    if (!arguments.run.quiet) {
        warn_of_missing_bubbles(preset, outcome);
        warn_of_late_events(preset, options.frames);
    }
    print(arguments, result, json_report(outcome));
    return outcome.status == RunStatus::Complete ? ExitCode::Success : report_failure(outcome);
}

ExitCode run_preview(const PreviewArguments& arguments) {
    std::error_code ignored;  // a path that is not a folder is a preset
    const bool is_folder = std::filesystem::is_directory(arguments.run.preset, ignored);
    if (!arguments.shown_preset.empty() && !is_folder) {
        throw std::invalid_argument(
            fmt::format("--preset is only allowed with a folder, but '{}' is not a folder",
                        arguments.run.preset));
    }
    if (arguments.watch && is_folder) {
        throw std::invalid_argument("--watch is only allowed with a preset, not with a folder");
    }
    if (arguments.watch) {
        run_watching(arguments.run, [&] { preview_preset(arguments); });
    }
    return is_folder ? preview_folder(arguments) : preview_preset(arguments);
}

void add_choices(CLI::App& command, PreviewArguments& arguments) {
    command.get_option("PRESET")->description(
        "Name of a shipped preset, a .toml file, or a folder with baked images");
    add_maps_option(command,
                    arguments.maps,
                    "Maps, separated by commas (default for a preset: its first map; for a folder: "
                    "its first map of colors or, if it has none, its first map of numbers)");
    CLI::Option* const kinds =
        command
            .add_option("--as",
                        arguments.kinds,
                        "Kinds of previews, separated by commas (default: contact,loop, and tiling "
                        "if the first frame tiles)")
            ->delimiter(',')
            ->allow_extra_args(false);
    allow_only(*kinds, {kPreviewNames.begin(), kPreviewNames.end()});
    command
        .add_option("--width",
                    arguments.animation_size,
                    "Largest width and height of animations in pixels (default: 384)")
        ->check(CLI::Range(1, kMaxAnimationSize))
        ->option_text("PX");
    add_preset_name_option(command, arguments.shown_preset);
    add_out_folder_option(
        command,
        arguments.out,
        "Folder for the previews (default for a preset: out; for a folder: the folder itself)");
}

}  // namespace

void add_preview_command(CLI::App& app, Action& action) {
    CLI::App* command =
        app.add_subcommand("preview", "Show a preset or a bake: contact sheet, tiling, animation");
    const auto arguments = std::make_shared<PreviewArguments>();
    add_preset_options(*command, arguments->run);
    add_choices(*command, *arguments);
    add_json_option(*command, arguments->json);
    add_watch_option(*command, arguments->watch);
    add_run_options(*command, arguments->run);
    command->footer(kPreviewExamples);
    command->callback(
        [&action, arguments] { action = [arguments] { return run_preview(*arguments); }; });
}

}  // namespace foam::texgen
