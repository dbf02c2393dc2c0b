// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/geometry/vec2.h"
#include "texgen/maps/frame_layers.h"
#include "texgen/raster/coords/fixed_point.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace foam::texgen {

/// The values of a grain (see the class Grain below) differ from their mean by at most this number.
inline constexpr double kGrainBound = 2.0;

/// The use of a grain. Grains of different uses are independent of each other.
enum class GrainUse : std::uint32_t { Relief, Albedo };

/// A value of a grain.
struct GrainValue {
    // Differs from the mean of all values of the grain rarely by more than 1, and never by more
    // than kGrainBound.
    double value = 0.0;
    Vec2 gradient = Vec2::Zero();  // of the value; x to the right, y up
};

/// Returns the sum of several octaves of gradient noise at a point (K. Perlin, "Improving noise",
/// 2002). The first octave has features of size 1. The features of each further octave have half
/// the size and half the height of the features of the preceding octave. The gradient is the
/// derivative with respect to `point`. The noise depends only on the arguments. Precondition:
/// `octaves` is from 1 to 30.
GrainValue octave_noise(const Vec2& point, std::uint32_t seed, int octaves);

/// A fine texture of noise in every bubble. It moves with the centroid of the bubble, does not turn
/// or stretch, and differs from bubble to bubble. There is no noise around a patch. There are up
/// to five octaves: the first one, and further ones whose features are not smaller than two pixels.
/// If a bubble of a torus extends beyond half the width or height of the image from its centroid,
/// the noise has a visible step at this distance. Borrows the layers.
class Grain {
  public:
    /// `size` is the size of the largest features, in diameters of a mean bubble of the seeded
    /// foam. `mean` is the mean of the values in bubbles.
    Grain(FrameLayers& layers, double size, GrainUse use, double mean = 0.0);

    /// Returns the value at the center of a pixel; its gradient is per pixel. `index` counts pixels
    /// row by row from the bottom row.
    GrainValue at(std::size_t index) const;

  private:
    /// The grain of one bubble.
    struct Origin {
        SubpixelPoint center{};  // centroid of the bubble on the unshifted grid
        std::uint32_t seed = 0;  // 0 around a patch
    };

    std::vector<Origin> origins_of(FrameLayers& layers, GrainUse use) const;
    Vec2 from_center(std::size_t index, SubpixelPoint center) const;

    RasterGrid grid_;
    bool is_periodic_;
    std::int32_t shear_ = 0;  // shear of a torus, subpixels
    double size_;             // size of the largest features, pixels
    int octaves_;
    double mean_;
    const Image<std::uint32_t>* ids_;
    std::vector<Origin> origins_;  // indexed by the ids of the distance field
};

}  // namespace foam::texgen
