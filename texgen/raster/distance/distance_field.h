// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/image/image.h"

#include <cstdint>

namespace foam::texgen {

/// The images of a DistanceField that are computed in addition to ids and distances.
struct DistanceNeeds {
    bool gradient = false;
    bool smooth = false;  // the smooth distance and its gradient
};

/// The bubble at the center of each pixel, and the distance from the center to the nearest film.
/// Images have one channel; gradients have two, x to the right and y up. Images that are not in the
/// DistanceNeeds are empty.
struct DistanceField {
    /// The index of the bubble whose outline, for films of no width, encloses the pixel's center.
    /// In a patch the surroundings have the index of the ghost bubble, and lone bubbles follow in
    /// their order, as in CellValues. Where bubbles of a patch overlap, the one with the largest
    /// index counts.
    Image<std::uint32_t> ids;
    /// The distance to the nearest point of a film in pixels, never negative. It is infinite if
    /// there is no film. The error is at most 1e-6 of the distance or of 8 pixels, whichever is
    /// larger. On a sheared torus, the shear is rounded to a whole number of subpixels, as in the
    /// grid.
    Image<float> distance;
    /// The unit vector that points away from the nearest point of a film; zero in the center of a
    /// circle.
    Image<float> gradient;
    /// The smooth distance s in pixels, never negative. Like the distance, it is 0 and has slope 1
    /// on a film, but it has no creases within a bubble. 1/s² is the sum of 1/phi² over the films
    /// of the bubble, where phi is the function of Biswas and Shapiro, "Approximate distance fields
    /// with non-vanishing gradients" (2004). In the middle of a bubble s is smaller than the
    /// distance. In a lone bubble of radius R, at r from its center, s = (R² - r²) / 2R. Around a
    /// patch s is the distance.
    Image<float> smooth;
    /// The gradient of the smooth distance per pixel; its length is 1 on films and 0 at summits.
    Image<float> smooth_gradient;
};

}  // namespace foam::texgen
