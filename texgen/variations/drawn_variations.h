// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/animation/progress.h"
#include "texgen/animation/simulate_frames.h"
#include "texgen/image/image.h"
#include "texgen/preset/preset.h"

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace foam::texgen {

/// The options of draw_variations.
struct VariationDrawing {
    int frame = 1;    // the number of the frame
    std::string map;  // name of the map
    int side = 256;   // largest width and height of a picture, in pixels (reduced_image)
    int threads = 0;  // 0: one per hardware thread
};

/// The picture of a variation.
struct DrawnVariation {
    Image<std::uint8_t> pixels;  // three channels; gray if the run failed
    RunOutcome outcome;
};

/// Returns the estimated peak memory, in bytes, of a process that calls draw_variations and joins
/// the pictures to a sheet. As many pictures are drawn at once as there are threads. The estimate
/// is usually right within a factor of 1.5.
std::uint64_t estimated_memory(std::span<const Preset> presets, const VariationDrawing& drawing);

/// Draws a frame of each preset as a bake does, reduced to `drawing.side` (reduced_image), and
/// composited over gray where it is transparent. `on_progress` receives the phase Phase::Previews,
/// which counts pictures. Throws std::invalid_argument if the pictures have different sizes, or if
/// the map stores whole numbers (check_shown_map), and the exceptions of bake_recorded.
/// Precondition: there is at least one preset.
std::vector<DrawnVariation> draw_variations(std::span<const Preset> presets,
                                            const VariationDrawing& drawing,
                                            const ProgressCallback& on_progress = {});

}  // namespace foam::texgen
