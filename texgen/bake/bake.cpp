// SPDX-License-Identifier: Apache-2.0

#include "texgen/bake/bake.h"

#include "core/files/file_io.h"
#include "core/parallel/parallel_for.h"
#include "texgen/animation/drawable_frame.h"
#include "texgen/animation/progress_meter.h"
#include "texgen/animation/seconds_since.h"
#include "texgen/animation/simulate_frames.h"
#include "texgen/bake/bounded_workers.h"
#include "texgen/bake/file_pattern.h"
#include "texgen/bake/frame_files.h"
#include "texgen/bake/measurements.h"
#include "texgen/bake/vector_files.h"
#include "texgen/image/format.h"
#include "texgen/preset/drawn_images.h"

#include <fmt/core.h>

#include <algorithm>
#include <chrono>
#include <memory>
#include <mutex>
#include <optional>
#include <stdexcept>

// A pipeline of one producer and several consumers. The caller's thread takes frames from the
// source, usually the simulation, and submits a job for each frame. Worker threads draw, encode and
// write one frame per job. The queue of jobs is bounded (bounded_workers.h), so memory does not
// grow with the number of frames.

namespace foam::texgen {

namespace {

using Clock = std::chrono::steady_clock;

FrameSource source_of(const Preset& preset, const BakeOptions& options) {
    return options.source ? options.source : simulation_of(preset, options.threads);
}

/// Draws frames, writes their files and reports them. `write` may be called from several threads at
/// once.
class FrameWriter {
  public:
    FrameWriter(const Preset& preset, int total, const BakeCallbacks& callbacks)
        : preset_(preset),
          files_(preset),
          callbacks_(callbacks),
          meter_(Phase::Frames, total, callbacks.on_progress) {}

    /// Returns Included if drawing a frame also needs the frame after it, otherwise Omitted.
    NextFrames next_frames() const {
        return files_.needs_next() ? NextFrames::Included : NextFrames::Omitted;
    }

    /// Returns the paths of the files of all frames that are in both `frames` and `done`, in the
    /// order of `frames`.
    std::vector<std::filesystem::path> paths(const std::vector<int>& frames,
                                             const std::set<int>& done) const {
        std::vector<std::filesystem::path> all;
        for (const int frame : frames) {
            if (done.contains(frame)) {
                const std::vector<std::filesystem::path> paths = files_.paths(frame);
                all.insert(all.end(), paths.begin(), paths.end());
            }
        }
        return all;
    }

    /// Returns the ranges and the extents of the numbers in the written files, one element per
    /// image (BakeSummary::numbers). Must not be called during `write`.
    const std::vector<WrittenNumbers>& numbers() const { return numbers_; }

    /// Returns the progress meter of Phase::Frames. The meter counts the written frames.
    ProgressMeter& meter() { return meter_; }

    void write(const SimulatedFrame& shown) {
        const Clock::time_point begin = Clock::now();
        BakedFrame baked{shown, write_files(shown)};
        baked.measurements = measurements_json(shown, preset_.output.measurements);
        baked.seconds = seconds_since(begin);
        report(baked);
    }

  private:
    std::vector<WrittenFile> write_files(const SimulatedFrame& shown) const {
        if (files_.is_vector()) {
            return files_.write_vectors(shown);
        }
        const RasterGrid grid{preset_.image.width, preset_.image.height, 0, 0, shown.view};
        DrawableFrame drawable(shown, grid, files_.needed_distance(), 1);
        return files_.write(drawable.layers());
    }

    void report(const BakedFrame& baked) {
        const std::scoped_lock lock(mutex_);
        if (callbacks_.on_baked) {
            callbacks_.on_baked(baked);
        }
        for (const WrittenFile& file : baked.files) {
            if (file.numbers) {
                add_numbers(file);
            }
        }
        meter_.add(baked.shown);
    }

    // Precondition: `file.numbers` is set. The file then stores codes, so it has only one
    // image, and this image has a range.
    void add_numbers(const WrittenFile& file) {
        const DrawnImage& image = file.images.front().first;
        const auto found = std::ranges::find_if(numbers_, [&](const WrittenNumbers& numbers) {
            return numbers.image.name() == image.name();
        });
        if (found == numbers_.end()) {
            numbers_.push_back({image, *file.images.front().second.range, *file.numbers});
        } else {
            found->extent = joined(found->extent, *file.numbers);
        }
    }

    const Preset& preset_;
    FrameFiles files_;
    const BakeCallbacks& callbacks_;
    std::mutex mutex_;
    std::vector<WrittenNumbers> numbers_;
    ProgressMeter meter_;
};

// Throws std::invalid_argument if the format of the files cannot store the primaries of colors.
void check_primaries(const Preset& preset, const FilePattern& pattern) {
    const bool has_numbers =
        !pattern.is_vector() && pattern.format().samples == FormatSamples::Numbers;
    if (preset.output.primaries != Primaries::Srgb && !has_numbers) {
        throw std::invalid_argument(
            fmt::format("output.primaries = \"acescg\" needs EXR files, but output.pattern is '{}'",
                        preset.output.pattern));
    }
}

// Throws std::invalid_argument if a format cannot store a packing.
void check_packings(const std::vector<DrawnImage>& images, const ImageFormat& format) {
    for (const DrawnImage& image : images) {
        if (image.packs_colors() && format.samples == FormatSamples::Numbers) {
            throw std::invalid_argument(fmt::format(
                "packing '{}': {} files store colors multiplied by their opacity, which "
                "a packing does not have; bake the maps as {} layers instead",
                image.name(),
                format.name,
                format.name));
        }
    }
}

}  // namespace

void check_bake(const Preset& preset, const BakeOptions& options) {
    if (options.frames.empty() ||
        *std::min_element(options.frames.begin(), options.frames.end()) < 1) {
        throw std::invalid_argument(
            "at least one frame is needed, and frame numbers must be at least 1");
    }
    const FilePattern pattern(preset);
    pattern.check_distinct(options.frames.size(), file_words(preset).size());
    check_primaries(preset, pattern);
    check_vector_files(preset);
    check_measurements(preset, options.frames.size());
    if (!pattern.is_vector()) {
        check_file_words(preset);
        check_packings(drawn_images(preset), pattern.format());
    }
    for (const std::filesystem::path& path : FrameFiles(preset).paths(options.frames.front())) {
        check_writable(path.parent_path());
    }
}

BakeSummary bake(const Preset& preset, const BakeOptions& options, const BakeCallbacks& callbacks) {
    const auto total = static_cast<int>(options.frames.size() - options.existing_frames.size());
    FrameWriter writer(preset, total, callbacks);
    BoundedWorkers workers(thread_count(options.threads) - 1);
    std::set<int> done;
    const auto draw = [&](const SimulatedFrame& shown) {
        done.insert(shown.frame->number);
        if (callbacks.on_frame) {
            callbacks.on_frame(shown);
        }
        if (!options.existing_frames.contains(shown.frame->number)) {
            writer.meter().begin();
            workers.submit([shown, &writer] { writer.write(shown); });
        }
    };
    const RunOutcome outcome = source_of(preset, options)(
        options.frames, writer.next_frames(), draw, writer.meter().for_source());
    workers.finish();
    return {outcome, writer.paths(options.frames, done), writer.numbers()};
}

}  // namespace foam::texgen
