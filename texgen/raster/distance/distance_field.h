// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/image/image.h"

#include <cstdint>

namespace foam::texgen {

/// The images of the smooth distance that are computed. Each selection includes the ones before it.
enum class SmoothImages {
    None,
    Distance,             // DistanceField::smooth
    DistanceAndGradient,  // also DistanceField::smooth_gradient
};

/// Selects the images of a DistanceField that are computed in addition to ids.
struct DistanceNeeds {
    bool distance = true;
    bool gradient = false;  // the gradient of the distance
    SmoothImages smooth = SmoothImages::None;
};

/// The bubble at the center of each pixel, and the distance from this center to the nearest film.
/// Gradients are images of two channels: x to the right and y up. All other images have one
/// channel. Images that the DistanceNeeds do not select are empty.
struct DistanceField {
    /// The index of the bubble whose outline encloses the center of the pixel. Films count as lines
    /// without a width. In a patch the surroundings have the index of the ghost bubble, and the
    /// indices of the lone bubbles follow, in the order of Frame::lone_bubbles. Where bubbles of a
    /// patch overlap, the pixel gets the largest index of these bubbles.
    Image<std::uint32_t> ids;
    /// The distance in pixels to the nearest point of a film, never negative. A region is a bubble
    /// or the surroundings of a patch. The distance is infinite if the region of the pixel has no
    /// film on its boundary, as in a patch without bubbles. The error is at most 1e-6 times the sum
    /// of the distance and 8 pixels. On a sheared torus, the shear is rounded to a whole number of
    /// subpixels, as it is for the ids.
    Image<float> distance;
    /// The unit vector that points away from the nearest point of a film. It is zero at the center
    /// of a circle and where there is no film.
    Image<float> gradient;
    /// The smooth distance s in pixels, never negative (README.md). Like the distance, s is 0 and
    /// has slope 1 on a film, but s has no creases within a bubble. In the middle of a bubble s is
    /// smaller than the distance. In a lone bubble of radius R, s = (R² - r²) / (2 R) at a distance
    /// r from its center. In the surroundings of a patch s is the distance.
    Image<float> smooth;
    /// The gradient of the smooth distance, in pixels per pixel. In a bubble, its length is 1 on
    /// films and 0 at the maxima of the smooth distance.
    Image<float> smooth_gradient;
};

}  // namespace foam::texgen
