// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/bake/bake.h"
#include "texgen/preset/preset.h"

#include <cstddef>
#include <cstdint>

namespace foam::texgen {

/// The files and the time of a bake, estimated from its first frames, and its memory, estimated
/// from the preset (estimated_memory). Scene files and statistics are not included. Sheets are
/// included only in the memory.
struct BakeEstimate {
    std::size_t files = 0;     // number of files: images, or drawings, tables and meshes
    std::uint64_t bytes = 0;   // size of these files
    std::uint64_t memory = 0;  // peak, in bytes (estimated_memory)
    double seconds = 0.0;      // wall time
    double simulating = 0.0;   // seconds that a simulation of all frames takes
    double drawing = 0.0;      // seconds that drawing all frames and fitting automatic ranges take
    // The outcome of the bake of the first frames. If this bake failed, the members above except
    // `memory` are 0.
    RunOutcome outcome{};
};

/// The number of frames that estimate_bake bakes, unless the bake has fewer.
inline constexpr std::size_t kEstimatedFrames = 2;

/// The largest width and height of the images that estimate_bake draws, which limits the memory of
/// an estimate. Images whose width and height have too small a common divisor are drawn larger
/// (reduced_image).
inline constexpr int kMaxEstimatedSide = 2048;

/// Bakes the first two frames into a scratch folder, which is removed afterwards. Measures the time
/// before the first frame, the time from frame to frame, the time of drawing and writing, and the
/// size of the files. Extrapolates to all frames, on the assumption that all threads share the
/// drawing and writing equally. Images larger than kMaxEstimatedSide are drawn at a reduced
/// size. Their time of drawing and the size of their files are then multiplied by the ratio of the
/// numbers of pixels, which usually overestimates the size. `on_progress` receives the phases of
/// the bake of the first frames. Throws the exceptions of check_bake and bake, and OutputError if
/// the scratch folder cannot be created.
BakeEstimate estimate_bake(const Preset& preset,
                           const BakeOptions& options,
                           const ProgressCallback& on_progress);

}  // namespace foam::texgen
