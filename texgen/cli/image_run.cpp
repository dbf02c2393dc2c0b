// SPDX-License-Identifier: Apache-2.0

#include "texgen/cli/image_run.h"

#include "texgen/bake/estimated_size.h"
#include "texgen/bake/file_pattern.h"
#include "texgen/bake/frame_range.h"
#include "texgen/bake/vector_files.h"
#include "texgen/cli/dry_run.h"
#include "texgen/cli/interruption.h"
#include "texgen/cli/json_report.h"
#include "texgen/cli/memory_need.h"
#include "texgen/cli/report.h"
#include "texgen/cli/standard_error.h"
#include "texgen/cli/standard_output.h"
#include "texgen/image/format.h"
#include "texgen/manifest/bake_recorder.h"
#include "texgen/manifest/manifest_file.h"
#include "texgen/manifest/recorded_bake.h"
#include "texgen/maps/all_maps.h"
#include "texgen/material/scene_files.h"
#include "texgen/preset/drawn_images.h"
#include "texgen/sheet/flipbook.h"
#include "texgen/stats/files.h"
#include "texgen/stats/record.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <span>
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

/// A run that has ended.
struct FinishedRun {
    const ImageRun& run;
    BakeSummary summary;
    OtherFiles written;

    bool is_complete() const { return summary.outcome.status == RunStatus::Complete; }
};

Json report_of(const FinishedRun& finished) {
    const Preset& preset = finished.run.preset;
    Json report = json_report(finished.summary.outcome);
    report["preset"] = preset.name;
    report["frames"] = format_frame_range(finished.run.options.frames);
    report["kept"] = finished.summary.kept;
    report["manifest"] = (manifest_folder(preset) / kManifestName).string();
    report["files"] = path_list(finished.summary.files);
    report["sheets"] = path_list(finished.written.sheets);
    report["scenes"] = path_list(finished.written.scenes);
    report["statistics"] = path_list(finished.written.statistics.paths);
    return report;
}

/// Prints the JSON object of the runs that have ended. `count` is the number of all runs.
void print_report(const std::vector<FinishedRun>& finished, std::size_t count) {
    if (count == 1) {
        print_json(report_of(finished.front()));
        return;
    }
    Json report = json_report(finished.back().summary.outcome);
    report["sizes"] = Json::array();
    for (const FinishedRun& one : finished) {
        Json size_report = report_of(one);
        size_report["size"] = {one.run.preset.image.width, one.run.preset.image.height};
        report["sizes"].push_back(std::move(size_report));
    }
    print_json(report);
}

std::filesystem::path statistics_folder(const Preset& preset, const FilePattern& pattern) {
    const std::filesystem::path image = pattern.path(file_words(preset).front(), 1);
    return image.parent_path() / (preset.name + "_stats");
}

MemoryNeed memory_of(const ImageRun& run) {
    return memory_to_bake(run.preset, run.options.frames.size(), run.options.threads);
}

/// Returns true if the command warns of files of other bakes that it replaces. With --watch, it
/// does not, because every bake replaces the files of the previous one.
bool warns_of_replaced(const ImageArguments& arguments, const ProgressOptions& progress) {
    return progress.verbosity != Verbosity::Quiet && !arguments.watch;
}

/// Draws the frames and writes the image files and their manifest. `has_frame` is true if an
/// earlier ImageRun of the same command has written frames. `on_frame` may be empty.
BakeSummary bake_images(const ImageRun& run,
                        const ImageArguments& arguments,
                        const ProgressOptions& progress,
                        bool has_frame,
                        const FrameVisitor& on_frame) {
    std::function<void(const std::vector<ReplacedFiles>&)> on_replace;
    if (warns_of_replaced(arguments, progress)) {
        on_replace = warn_of_replaced_files;
    }
    has_frame = has_frame || arguments.resume;  // true if --resume may find frames
    const auto bake = [&] {
        ProgressReporter reporter(progress);
        const auto on_progress = [&, report = reporter.callback()](const RunProgress& latest) {
            has_frame = has_frame || (latest.phase == Phase::Frames && latest.done > 0);
            report(latest);
        };
        return bake_recorded(
            run.preset,
            run.options,
            {.on_progress = on_progress, .on_frame = on_frame},
            {.resume = arguments.resume ? Resume::Yes : Resume::No, .on_replace = on_replace});
    };
    try {
        return with_memory(memory_of(run), bake);
    } catch (const Interrupted&) {
        print_stderr("foamtex: {}",
                     has_frame ? "to continue, run the same command with --resume"
                               : "no frame was written; to start again, run the same command");
        throw;
    }
}

/// Writes the sheets and the scene files that the keys output.sheets and output.scene request.
OtherFiles write_sheets_and_scenes(const ImageRun& run,
                                   const ImageArguments& arguments,
                                   const ProgressOptions& progress) {
    OtherFiles written;
    if (run.preset.output.sheets != SheetKind::None) {
        const Flipbook flipbook = [&] {
            ProgressReporter reporter(progress);
            return write_sheets(run.preset, run.options.frames, reporter.callback());
        }();
        if (warns_of_replaced(arguments, progress)) {
            report_earlier_sheets(flipbook);
        }
        written.sheets = flipbook.files;
    }
    if (!run.preset.output.scene.empty()) {
        written.scenes = write_scenes(run.preset);
    }
    return written;
}

/// Throws if one of the runs is not possible, before any of them begins.
void check_runs(std::span<const ImageRun> runs) {
    for (const auto& [preset, options] : runs) {
        check_scenes(preset);
        check_sheets(preset);
        check_bake(preset, options);
    }
}

/// Warns of a disk or a memory that is too small for the runs, which are made one after the other.
void warn_of_resources(std::span<const ImageRun> runs) {
    std::uint64_t size = 0;
    MemoryNeed largest;
    for (const ImageRun& run : runs) {
        size += estimated_size(run.preset, run.options.frames);
        const MemoryNeed need = memory_of(run);
        largest = need.bytes > largest.bytes ? need : largest;
    }
    warn_of_full_disk(size, manifest_folder(runs.front().preset));
    warn_of_little_memory(largest);
}

/// Carries out one of the runs of a command. If it is complete, also writes its sheets and scene
/// files. If `is_first`, also writes the statistics that the command asks for.
FinishedRun carry_out(const ImageRun& run,
                      const ImageArguments& arguments,
                      const ProgressOptions& progress,
                      bool is_first) {
    const bool with_statistics = arguments.stats && is_first;
    const Preset& preset = run.preset;
    Recorder recorder(preset, run.options.threads);
    FinishedRun finished{run,
                         bake_images(run,
                                     arguments,
                                     progress,
                                     !is_first,
                                     with_statistics ? recorder.visitor() : FrameVisitor()),
                         {}};
    if (finished.is_complete()) {
        finished.written = write_sheets_and_scenes(run, arguments, progress);
    }
    if (with_statistics) {
        finished.written.statistics =
            write_statistics(recorder.run(), statistics_folder(preset, FilePattern(preset)));
    }
    if (progress.verbosity != Verbosity::Quiet) {
        warn_of_clipped(finished.summary, preset);
    }
    return finished;
}

void print_names(const FinishedRun& finished) {
    const Preset& preset = finished.run.preset;
    const OtherFiles& written = finished.written;
    print_images(preset, FilePattern(preset), finished.run.options.frames);
    print_files(written.sheets);
    print_files(written.scenes);
    print_files(written.statistics.paths);
    note_missing_charts(written.statistics);
}

}  // namespace

ExitCode run_images(std::span<const ImageRun> runs,
                    const ImageArguments& arguments,
                    const ProgressOptions& progress) {
    check_runs(runs);
    const bool is_quiet = progress.verbosity == Verbosity::Quiet;
    if (!is_quiet) {
        note_unused_normal_y(arguments, runs.front().preset);
        warn_of_resources(runs);
    }
    if (arguments.dry_run) {
        return print_estimate(runs, arguments.json, progress);
    }
    for (const ImageRun& run : runs) {
        check_sheet_folder(run.preset);
    }
    if (arguments.stats) {
        const Preset& preset = runs.front().preset;
        check_writable(statistics_folder(preset, FilePattern(preset)));
    }
    std::vector<FinishedRun> finished;
    for (const ImageRun& run : runs) {
        const bool is_first = finished.empty();
        finished.push_back(carry_out(run, arguments, progress, is_first));
        if (!is_quiet && is_first) {
            warn_of_missing_bubbles(run.preset, finished.back().summary.outcome);
        }
        if (!finished.back().is_complete()) {
            break;
        }
        if (!is_quiet && !arguments.json) {
            print_names(finished.back());
        }
    }
    if (arguments.json) {
        print_report(finished, runs.size());
    }
    return finished.back().is_complete() ? ExitCode::Success
                                         : report_failure(finished.back().summary.outcome);
}

}  // namespace foam::texgen
