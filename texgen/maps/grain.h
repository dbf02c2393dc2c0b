// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/foam/frame.h"
#include "texgen/image/image.h"
#include "texgen/raster/coords/raster_grid.h"

#include <cstdint>
#include <tuple>

namespace foam::texgen {

/// The values of a grain (see Grain below) differ from their mean by at most this number.
inline constexpr double kGrainBound = 2.0;

/// The use of a grain. Grains of different uses are independent of each other.
enum class GrainUse : std::uint32_t { Relief, Albedo };

/// Returns the seed of the noise in a bubble. It is never 0.
std::uint32_t seed_of_grain(BubbleIdentity identity, GrainUse use);

/// A grain at the centers of pixels: its values and their gradients per pixel (x to the right, y
/// up), in images of one channel. Images that are not selected (GrainImages) are empty. The values
/// differ from their mean rarely by more than 1, and never by more than kGrainBound.
struct Grain {
    Image<float> value;
    Image<float> slope_x;
    Image<float> slope_y;
};

/// The images of a grain that are drawn.
enum class GrainImages { Values, ValuesAndSlopes };

/// Tells which grain to draw.
struct GrainRule {
    // The size of the largest features, in diameters of a mean bubble of the seeded foam.
    double size = 0.1;
    GrainUse use = GrainUse::Relief;
    double mean = 0.0;  // mean of the values in bubbles

    friend bool operator<(const GrainRule& a, const GrainRule& b) {
        return std::tie(a.size, a.use, a.mean) < std::tie(b.size, b.use, b.mean);
    }
};

/// Draws a fine texture of noise in every bubble. The texture moves with the centroid of the
/// bubble, does not turn or stretch, and differs from bubble to bubble. There is no noise around a
/// patch: the values there are 0. There are up to five octaves: the first one, and further ones
/// whose features are not smaller than two pixels. On a torus, a bubble may extend farther from its
/// centroid than half the width or height of the image. The noise then has a visible step at this
/// distance. `ids` are the ids of the distance field of the frame (DistanceField::ids). Maps get
/// their grain from FrameLayers::grain, which draws each grain only once.
Grain draw_grain(const Frame& frame,
                 const RasterGrid& grid,
                 const Image<std::uint32_t>& ids,
                 const GrainRule& rule,
                 GrainImages images,
                 int threads);

}  // namespace foam::texgen
