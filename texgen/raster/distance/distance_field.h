#pragma once

#include "texgen/image/image.h"

#include <cstdint>

namespace foam::texgen {

/// Names the images of a DistanceField that are computed besides ids and distances.
struct DistanceNeeds {
    bool gradient = false;
    bool smooth = false;  // the smooth distance and its gradient
};

/// The bubble at the center of each pixel and the distance from there to the nearest film. Images
/// have one channel; gradients have two, x to the right and y up. Images that were not asked for
/// are empty.
struct DistanceField {
    /// The index of the bubble whose outline, for films of no width, encloses the pixel's center.
    /// In a patch the ghost's index stands for the surroundings, and lone bubbles follow it in
    /// their order, as in CellValues. Where bubbles of a patch overlap, the last one counts.
    Image<std::uint32_t> ids;
    /// The distance to the nearest point of a film in pixels, never negative. The error is at most
    /// 1e-6 of the distance or of 8 pixels, whichever is larger. Infinite if there is no film. On a
    /// sheared torus the shear is the grid's, a whole number of subpixels.
    Image<float> distance;
    /// The unit vector that points away from the nearest point; zero in the center of a circle.
    Image<float> gradient;
    /// A smooth function that is 0 and has slope 1 on a film, as the distance does, but has no
    /// creases within a bubble; in pixels, never negative. 1/s² is the sum of 1/phi² over the films
    /// of the bubble, with the phi of Biswas and Shapiro, "Approximate distance fields with
    /// non-vanishing gradients" (2004). In the middle of a bubble it is smaller than the distance.
    /// In a lone bubble of radius R it is (R² - r²) / 2R. Around a patch it is the distance.
    Image<float> smooth;
    /// The gradient of the smooth distance per pixel; its length is 1 on films and 0 at summits.
    Image<float> smooth_gradient;
};

}  // namespace foam::texgen
