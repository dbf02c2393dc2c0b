// SPDX-License-Identifier: Apache-2.0

#include "texgen/manifest/recorded_bake.h"

#include "core/files/file_io.h"
#include "core/files/shown_text.h"
#include "texgen/bake/fitted_ranges.h"
#include "texgen/bake/frame_files.h"
#include "texgen/bake/frame_range.h"
#include "texgen/cache/shared_simulation.h"
#include "texgen/cache/stored_ranges.h"
#include "texgen/manifest/bake_recorder.h"
#include "texgen/manifest/describe.h"
#include "texgen/manifest/existing_frames.h"
#include "texgen/manifest/manifest_file.h"
#include "texgen/maps/all_maps.h"
#include "texgen/preset/drawn_images.h"

#include <fmt/core.h>

#include <chrono>
#include <cstddef>
#include <exception>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace foam::texgen {

namespace {

// Throws std::invalid_argument if a file has the path of the manifest, or if its path relative to
// the folder of the manifest is not UTF-8. A manifest is JSON, which can store only UTF-8.
void check_names(const Preset& preset, const BakeOptions& options) {
    const std::filesystem::path folder = manifest_folder(preset);
    for (const std::filesystem::path& path : FrameFiles(preset).paths(options.frames.front())) {
        const std::string name = relative_path(path, folder);
        if (name == kManifestName) {
            throw std::invalid_argument(
                fmt::format("file name pattern '{}': the file would have the name of the manifest, "
                            "'{}'",
                            preset.output.pattern,
                            kManifestName));
        }
        if (!is_utf8(name)) {
            throw std::invalid_argument(
                fmt::format("file name pattern '{}': the names of files must be UTF-8, because the "
                            "manifest lists them",
                            preset.output.pattern));
        }
    }
}

// Records the failure of a bake that ends with an exception, if the bake has begun to record.
// Ignores further exceptions, so that the caller can rethrow the original exception. Waits only
// briefly for the lock of the manifest, because the exception may be that the lock was not free.
void close_after_failure(BakeRecorder& recorder, const std::string& failure) {
    try {
        if (recorder.begun()) {
            recorder.close(failure, std::chrono::seconds(1));
        }
    } catch (const std::exception&) {
        return;
    }
}

// Bakes a preset and updates the manifest in the callbacks of the bake.
BakeSummary bake_and_record(const Preset& preset,
                            const BakeOptions& options,
                            const BakeCallbacks& callbacks,
                            BakeRecorder& recorder) {
    BakeCallbacks recording = callbacks;
    recording.on_frame = [&](const SimulatedFrame& shown) {
        recorder.begin();
        if (callbacks.on_frame) {
            callbacks.on_frame(shown);
        }
    };
    recording.on_baked = [&](const BakedFrame& baked) {
        recorder.add(baked);
        if (callbacks.on_baked) {
            callbacks.on_baked(baked);
        }
    };
    return bake(preset, options, recording);
}

// Fits the automatic ranges of a preset to the frames of a sequence. If the frames come from a
// cache, takes the ranges from the cache; if they are not stored there, fits them and stores them
// there. Precondition: if the preset has automatic ranges, options.source is not empty.
RunOutcome fit_ranges(Preset& preset,
                      const BakeOptions& options,
                      const std::vector<int>& sequence,
                      const BakeCallbacks& callbacks) {
    if (!has_automatic_ranges(preset)) {
        return {};
    }
    const bool has_cache = !options.cache.empty();
    const auto stored =
        has_cache ? std::optional<StoredRanges>({preset, sequence, options.cache}) : std::nullopt;
    if (stored && stored->load(preset)) {
        return {};
    }
    try {
        RunOutcome outcome = fit_automatic_ranges(
            preset, options.source, sequence, options.threads, callbacks.on_progress);
        if (stored && outcome.status == RunStatus::Complete) {
            stored->save(preset);
        }
        return outcome;
    } catch (const InputError& error) {
        throw InputError(
            fmt::format("{}; ranges that are \"auto\", such as height.full, need all "
                        "frames of the cache: wait until the simulation ends, or set a number",
                        error.what()));
    }
}

// Changes the automatic ranges of the maps of a preset to fixed numbers.
void make_ranges_fixed(Preset& preset) {
    for (const Map* const map : source_maps(preset)) {
        if (AutoReal* const full = range_option_of(*map, preset.maps)) {
            full->is_automatic = false;
        }
    }
}

// Calls RecordOptions::on_replace if the bake replaces files that the manifest lists in the sets of
// other bakes.
void report_replaced(const Preset& preset,
                     const BakeOptions& options,
                     const Manifest& manifest,
                     const RecordOptions& record) {
    if (!record.on_replace || manifest.sets.empty()) {
        return;
    }
    const std::vector<ReplacedFiles> replaced =
        replaced_files(manifest,
                       describe(preset, options.frames).parameters,
                       written_paths(preset, options, manifest_folder(preset)));
    if (!replaced.empty()) {
        record.on_replace(replaced);
    }
}

/// Returns the summary of a bake whose files all exist already. The closing error of the loop is
/// read from the manifest.
BakeSummary summary_of_existing(const Preset& preset,
                                const std::vector<int>& frames,
                                const Manifest& manifest) {
    const FrameFiles files(preset);
    BakeSummary summary;
    if (const BakedSet* const set = find_same_set(manifest, describe(preset, frames))) {
        summary.outcome.closing_error = set->loop.closing_error;
    }
    for (const int frame : frames) {
        const std::vector<std::filesystem::path> paths = files.paths(frame);
        summary.files.insert(summary.files.end(), paths.begin(), paths.end());
    }
    return summary;
}

}  // namespace

BakeSummary bake_recorded(const Preset& given,
                          const BakeOptions& options,
                          const BakeCallbacks& callbacks,
                          const RecordOptions& record) {
    check_bake(given, options);
    check_names(given, options);
    const std::filesystem::path folder = manifest_folder(given);
    check_writable(folder);
    Preset preset = given;
    const std::vector<int> animation = frames_to(preset.frames.count);
    const std::vector<int>& sequence = options.sequence.empty() ? animation : options.sequence;
    BakeOptions effective = options;
    // Automatic ranges need all frames before the first one is drawn. One simulation serves both
    // the fitting of the ranges and the drawing.
    SharedSimulation simulation(preset, united(options.frames, sequence), options.threads);
    if (!options.source && has_automatic_ranges(preset)) {
        effective.source = simulation.source(preset);
    }
    RunOutcome fitted;
    if (sequence != animation) {
        fitted = fit_ranges(preset, effective, sequence, callbacks);
        make_ranges_fixed(preset);
    }
    const Manifest manifest = manifest_in(folder);
    if (record.resume == Resume::Yes) {
        effective.existing_frames = existing_frames_of(preset, options.frames, folder, manifest);
    }
    report_replaced(preset, effective, manifest, record);
    const bool all_exist =
        effective.existing_frames.size() == options.frames.size() && !callbacks.on_frame;
    if (!all_exist && sequence == animation) {
        fitted = fit_ranges(preset, effective, sequence, callbacks);
    }
    BakeRecorder recorder(preset, effective);
    try {
        BakeSummary summary;
        if (fitted.status != RunStatus::Complete) {
            summary.outcome = fitted;
        } else if (all_exist) {
            summary = summary_of_existing(preset, options.frames, manifest);
        } else {
            summary = bake_and_record(preset, effective, callbacks, recorder);
        }
        summary.kept = static_cast<int>(effective.existing_frames.size());
        recorder.close(failure_of(summary.outcome));
        return summary;
    } catch (const std::exception& error) {
        close_after_failure(recorder, error.what());
        throw;
    }
}

}  // namespace foam::texgen
