// SPDX-License-Identifier: Apache-2.0

#include "texgen/cli/image_run.h"

#include "texgen/bake/estimated_memory.h"
#include "texgen/bake/estimated_size.h"
#include "texgen/bake/file_pattern.h"
#include "texgen/bake/frame_range.h"
#include "texgen/bake/vector_files.h"
#include "texgen/cli/dry_run.h"
#include "texgen/cli/interruption.h"
#include "texgen/cli/json_report.h"
#include "texgen/cli/options.h"
#include "texgen/cli/report.h"
#include "texgen/cli/standard_error.h"
#include "texgen/cli/standard_output.h"
#include "texgen/image/format.h"
#include "texgen/image/memory.h"
#include "texgen/manifest/bake_recorder.h"
#include "texgen/manifest/manifest_file.h"
#include "texgen/manifest/recorded_bake.h"
#include "texgen/maps/all_maps.h"
#include "texgen/material/scene_files.h"
#include "texgen/preset/drawn_images.h"
#include "texgen/sheet/flipbook.h"
#include "texgen/stats/files.h"
#include "texgen/stats/record.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <new>
#include <utility>
#include <vector>

namespace foam::texgen {

namespace {

/// Prints one line per image, or one line if all images share a file. For a single frame, the line
/// is the name of the file. Otherwise it is the file name pattern of the image and the frame range,
/// such as "out/foam_lit.####.png 1-48", which programs for movie production understand.
void print_images(const Preset& preset,
                  const FilePattern& pattern,
                  const std::vector<int>& frames) {
    for (const std::string& word : file_words(preset)) {
        if (frames.size() == 1) {
            print_stdout("{}\n", pattern.path(word, frames.front()).string());
        } else {
            print_stdout("{} {}\n", pattern.path_pattern(word), format_frame_range(frames));
        }
        if (pattern.stores_all_maps_in_one_file()) {
            return;
        }
    }
}

/// Returns the keys that set the ranges of an image, and what to do with them to avoid clipping,
/// such as "raise height.full".
std::string advice_on_range(const DrawnImage& image, const MapOptions& options) {
    const auto maps = image.sources();
    const bool is_automatic = std::ranges::any_of(maps, [&](const Map* map) {
        const AutoReal* const range = range_option_of(*map, options);
        return range != nullptr && range->is_automatic;
    });
    return fmt::format(
        "{} {}", is_automatic ? "set" : "raise", fmt::join(image.range_keys(), " or "));
}

/// Prints a note for each image that has clipped samples.
void note_clipped(const BakeSummary& summary, const Preset& preset) {
    for (const WrittenNumbers& numbers : summary.numbers) {
        if (numbers.extent.clipped > 0.0) {
            print_stderr(
                "foamtex: {}: up to {:.3g} % of the samples of a file are outside of {:g} "
                "to {:g} and were clipped; the numbers are from {:.3g} to {:.3g}; {}",
                numbers.image.name(),
                100.0 * numbers.extent.clipped,
                numbers.range[0],
                numbers.range[1],
                numbers.extent.smallest,
                numbers.extent.largest,
                advice_on_range(numbers.image, preset.maps));
        }
    }
}

/// Prints a note if --normal-y is given, but no map depends on it.
void note_unused_normal_y(const ImageArguments& arguments, const Preset& preset) {
    const std::vector<const Map*> maps = source_maps(preset);
    if (arguments.normal_y && std::ranges::find(maps, kNormalMap.name, &Map::name) == maps.end()) {
        print_stderr(
            "foamtex: note: --normal-y has no effect, because the map normal is not drawn");
    }
}

/// The files that a run writes besides images and their manifest.
struct OtherFiles {
    std::vector<std::filesystem::path> sheets;
    std::vector<std::filesystem::path> scenes;
    StatisticsFiles statistics;
};

void print_report(const Preset& preset,
                  const BakeOptions& options,
                  const BakeSummary& summary,
                  const OtherFiles& written) {
    Json report = json_report(summary.outcome);
    report["preset"] = preset.name;
    report["frames"] = format_frame_range(options.frames);
    report["kept"] = summary.kept;
    report["manifest"] = (manifest_folder(preset) / kManifestName).string();
    report["files"] = path_list(summary.files);
    report["sheets"] = path_list(written.sheets);
    report["scenes"] = path_list(written.scenes);
    report["statistics"] = path_list(written.statistics.paths);
    print_json(report);
}

std::filesystem::path statistics_folder(const Preset& preset, const FilePattern& pattern) {
    const std::filesystem::path image = pattern.path(file_words(preset).front(), 1);
    return image.parent_path() / (preset.name + "_stats");
}

// Returns the assignment that the options --pack make.
Assignment pack_assignment(const std::vector<std::string>& packings) {
    Value::List list;
    std::string location;
    for (const std::string& packing : packings) {
        location += fmt::format("{}--pack {}", location.empty() ? "" : " ", packing);
        list.push_back({packing});
    }
    return {location, "output.pack", {std::move(list)}};
}

/// Draws the frames and writes the image files and their manifest.
BakeSummary bake_images(const Preset& preset,
                        const BakeOptions& options,
                        const ImageArguments& arguments,
                        const ProgressOptions& progress,
                        Recorder& recorder) {
    std::function<void(const std::vector<ReplacedFiles>&)> on_replace;
    if (progress.verbosity != Verbosity::Quiet) {
        on_replace = warn_of_replaced_files;
    }
    try {
        ProgressReporter reporter(progress);
        return bake_recorded(
            preset,
            options,
            {.on_progress = reporter.callback(),
             .on_frame = arguments.stats ? recorder.visitor() : FrameVisitor()},
            {.resume = arguments.resume ? Resume::Yes : Resume::No, .on_replace = on_replace});
    } catch (const Interrupted&) {
        print_stderr("foamtex: to continue, run the same command with --resume");
        throw;
    } catch (const std::bad_alloc&) {
        throw OutOfMemory(
            memory_needed(estimated_memory(preset, options.frames.size(), options.threads)));
    }
}

/// Writes what output.sheets and output.scene ask for.
OtherFiles write_sheets_and_scenes(const Preset& preset,
                                   const BakeOptions& options,
                                   const ProgressOptions& progress) {
    OtherFiles written;
    if (preset.output.sheets != SheetKind::None) {
        ProgressReporter reporter(progress);
        written.sheets = write_sheets(preset, options.frames, reporter.callback()).files;
    }
    if (!preset.output.scene.empty()) {
        written.scenes = write_scenes(preset);
    }
    return written;
}

}  // namespace

void add_image_options(CLI::App& command, ImageArguments& arguments) {
    add_maps_option(command, arguments.maps, "Maps to draw, separated by commas");
    command
        .add_option(
            "--pack", arguments.pack, "Also draw an image whose channels are maps; may be repeated")
        ->allow_extra_args(false)
        ->option_text("NAME=R,G,B[,A]");
    command
        .add_option(
            "--normal-y", arguments.normal_y, "Direction of green in normals: gl (up) or dx (down)")
        ->option_text("gl|dx");
    command
        .add_option(
            "--out",
            arguments.out,
            "Files: .png .exr .dds .ktx2 .svg .dxf .pdf .stl .glb .csv .json; {map}, {seed}, "
            "{KEY}, ####")
        ->option_text("PATTERN");
    command
        .add_option(
            "--scene", arguments.scene, "Also write the material as scene files: usda, mtlx, gltf")
        ->option_text("A,B");
    command
        .add_option("--wrap", arguments.wrap, "Border of a drawing: cut bubbles, or whole bubbles")
        ->option_text("cut|whole");
    command
        .add_flag(
            "--stats", arguments.stats, "Also write statistics to {preset}_stats beside the images")
        ->option_text(" ");
    command
        .add_flag("--resume",
                  arguments.resume,
                  "Keep existing frames that were made with the same settings")
        ->option_text(" ");
    command
        .add_flag("--dry-run",
                  arguments.dry_run,
                  "Estimate the files of the frames, memory and time; write nothing")
        ->option_text(" ");
    add_json_option(command, arguments.json);
}

std::vector<Assignment> assignments_of(const ImageArguments& arguments) {
    std::vector<Assignment> assignments;
    if (arguments.maps) {
        assignments.push_back(maps_assignment(*arguments.maps));
    }
    if (!arguments.pack.empty()) {
        assignments.push_back(pack_assignment(arguments.pack));
    }
    if (arguments.normal_y) {
        assignments.push_back(
            {"--normal-y " + *arguments.normal_y, "normal.y", {*arguments.normal_y}});
    }
    if (arguments.scene) {
        assignments.push_back(
            {"--scene " + *arguments.scene, "output.scene", list_value(*arguments.scene)});
    }
    if (arguments.wrap) {
        assignments.push_back({"--wrap " + *arguments.wrap, "vector.wrap", {*arguments.wrap}});
    }
    if (arguments.out) {
        assignments.push_back({"--out " + *arguments.out, "output.pattern", {*arguments.out}});
    }
    return assignments;
}

ExitCode run_images(const Preset& preset,
                    const BakeOptions& options,
                    const ImageArguments& arguments,
                    const ProgressOptions& progress) {
    const Verbosity verbosity = progress.verbosity;
    check_scenes(preset);
    check_sheets(preset);
    if (verbosity != Verbosity::Quiet) {
        note_unused_normal_y(arguments, preset);
        warn_of_full_disk(estimated_size(preset, options.frames), manifest_folder(preset));
        warn_of_little_memory(estimated_memory(preset, options.frames.size(), options.threads));
    }
    if (arguments.dry_run) {
        return print_estimate(preset, options, arguments.json, progress);
    }
    Recorder recorder(preset);
    const BakeSummary summary = bake_images(preset, options, arguments, progress, recorder);
    OtherFiles written;
    if (summary.outcome.status == RunStatus::Complete) {
        written = write_sheets_and_scenes(preset, options, progress);
    }
    if (arguments.stats) {
        written.statistics =
            write_statistics(recorder.run(), statistics_folder(preset, FilePattern(preset)));
    }
    if (verbosity != Verbosity::Quiet) {
        note_clipped(summary, preset);
        warn_of_missing_bubbles(preset, summary.outcome);
    }
    if (arguments.json) {
        print_report(preset, options, summary, written);
    }
    if (summary.outcome.status != RunStatus::Complete) {
        return report_failure(summary.outcome);
    }
    if (verbosity != Verbosity::Quiet && !arguments.json) {
        print_images(preset, FilePattern(preset), options.frames);
        print_files(written.sheets);
        print_files(written.scenes);
        print_files(written.statistics.paths);
        note_missing_charts(written.statistics);
    }
    return ExitCode::Success;
}

}  // namespace foam::texgen
