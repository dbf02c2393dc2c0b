// SPDX-License-Identifier: Apache-2.0

#include "texgen/bake/bake_estimate.h"

#include "core/files/scratch_folder.h"
#include "core/parallel/parallel_for.h"
#include "texgen/animation/seconds_since.h"
#include "texgen/bake/estimated_memory.h"
#include "texgen/bake/file_pattern.h"
#include "texgen/bake/fitted_ranges.h"
#include "texgen/bake/reduced_image.h"
#include "texgen/preset/drawn_images.h"

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <string>
#include <vector>

namespace foam::texgen {

namespace {

/// The times and the files of the frames that were baked.
struct MeasuredFrames {
    // For each frame, the time at which it was simulated, in seconds since the start of the bake.
    std::vector<double> begins;
    double drawing = 0.0;     // seconds of drawing and writing, of all frames together
    std::uint64_t bytes = 0;  // size of all files together
    std::size_t files = 0;    // number of files
};

/// Estimates the time of fitting automatic ranges to a frame, divided by the time of drawing the
/// frame. Fitting draws only the maps with such ranges, at a reduced size. The estimate assumes
/// that one of the images of the preset has such a range, and that all images take equally long.
double share_of_fitting(const Preset& preset) {
    if (!has_automatic_ranges(preset)) {
        return 0.0;
    }
    const ReducedImage image = reduced_image(preset, kMeasuredSide);
    return 1.0 /
           (image.reduction * image.reduction * static_cast<double>(drawn_images(preset).size()));
}

/// Estimates the times of a bake with the given number of frames, and stores them in `estimate`.
/// Without automatic ranges, frames are drawn while the next ones are simulated. With
/// automatic ranges, these ranges are fitted to the frames of the whole animation while it is
/// simulated, and then the frames are drawn.
void extrapolate(const MeasuredFrames& measured,
                 const Preset& preset,
                 double frames,
                 int threads,
                 BakeEstimate& estimate) {
    const auto count = static_cast<double>(measured.begins.size());
    const double preparation = measured.begins.front();
    const double step = (measured.begins.back() - preparation) / std::max(count - 1.0, 1.0);
    const double drawing = measured.drawing / count / threads;
    const double share = share_of_fitting(preset);
    const double simulated = share > 0.0 ? std::max<double>(frames, preset.frames.count) : frames;
    // The seconds of drawing, or of fitting ranges, while frames are simulated; and the seconds of
    // drawing after the last frame is simulated.
    const double meanwhile = share > 0.0 ? simulated * share * drawing : frames * drawing;
    const double afterwards = share > 0.0 ? frames * drawing : drawing;
    estimate.simulating = preparation + (simulated - 1.0) * step;
    estimate.drawing = frames * drawing + simulated * share * drawing;
    estimate.seconds = std::max(estimate.simulating, preparation + meanwhile) + afterwards;
}

/// Returns a source of the same frames for images whose width is divided by `reduction`.
FrameSource source_of_reduced(const FrameSource& source, double reduction) {
    return [source, reduction](const std::vector<int>& numbers,
                               NextFrames next_frames,
                               const FrameVisitor& visit,
                               const ProgressCallback& on_progress) {
        const auto visit_reduced = [&](SimulatedFrame frame) {
            if (frame.view) {
                frame.view->pixels_per_unit /= reduction;
            }
            visit(frame);
        };
        return source(numbers, next_frames, visit_reduced, on_progress);
    };
}

/// Reduces the images of a bake to sides of at most kMaxEstimatedSide pixels, if possible.
/// Returns the number of pixels of an image divided by the number of pixels of the reduced image.
double reduce_images(Preset& preset, BakeOptions& options) {
    const ReducedImage image = reduced_image(preset, kMaxEstimatedSide);
    if (image.reduction == 1.0 || FilePattern(preset).is_vector()) {
        return 1.0;
    }
    image.apply_to(preset);
    if (options.source) {
        options.source = source_of_reduced(options.source, image.reduction);
    }
    return image.reduction * image.reduction;
}

}  // namespace

BakeEstimate estimate_bake(const Preset& preset,
                           const BakeOptions& options,
                           const ProgressCallback& on_progress) {
    check_bake(preset, options);
    const ScratchFolder scratch;
    Preset measured_preset = preset;
    const std::string suffix = std::filesystem::path(preset.output.pattern).extension().string();
    // If the bake stores all maps of a frame as layers of one file, so does the bake of the first
    // kEstimatedFrames frames below.
    const bool is_layered = FilePattern(preset).stores_all_maps_in_one_file();
    const std::string name = (is_layered ? "######" : "{map}.######") + suffix;
    measured_preset.output.pattern = (scratch.path() / name).string();
    BakeOptions measured_options = options;
    measured_options.frames.resize(std::min(options.frames.size(), kEstimatedFrames));
    const double pixel_ratio = reduce_images(measured_preset, measured_options);

    MeasuredFrames measured;
    const auto begin = std::chrono::steady_clock::now();
    const BakeSummary summary =
        bake(measured_preset,
             measured_options,
             {.on_progress = on_progress,
              .on_frame =
                  [&](const SimulatedFrame&) { measured.begins.push_back(seconds_since(begin)); },
              .on_baked =
                  [&](const BakedFrame& baked) {
                      measured.drawing += pixel_ratio * baked.seconds;
                      measured.files += baked.files.size();
                      for (const WrittenFile& file : baked.files) {
                          measured.bytes += file.bytes;
                      }
                  }});
    const std::size_t frames = options.frames.size();
    BakeEstimate estimate{.memory = estimated_memory(preset, frames, options.threads),
                          .outcome = summary.outcome};
    if (summary.outcome.status == RunStatus::Complete) {
        const std::size_t measured_frames = measured_options.frames.size();
        estimate.files = measured.files * frames / measured_frames;
        const std::uint64_t bytes = measured.bytes * frames / measured_frames;
        estimate.bytes = static_cast<std::uint64_t>(pixel_ratio * static_cast<double>(bytes));
        extrapolate(
            measured, preset, static_cast<double>(frames), thread_count(options.threads), estimate);
    }
    return estimate;
}

}  // namespace foam::texgen
