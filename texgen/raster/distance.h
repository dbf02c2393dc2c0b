#pragma once

#include "core/foam/frame.h"
#include "texgen/image/image.h"
#include "texgen/raster/coords/raster_grid.h"

#include <cstdint>

namespace foam::texgen {

/// What of a DistanceField is wanted besides ids and distances.
struct DistanceNeeds {
    bool gradient = false;
    bool smooth = false;  // with its gradient
};

/// Where each pixel's centre lies in a foam. One channel, but for gradients, which have two: x to
/// the right, y up. Images that are not needed are empty.
struct DistanceField {
    /// The bubble's index; in a patch, the ghost's index for what is around it, and lone bubbles
    /// follow in their order, as in CellValues. Every pixel is of one bubble: the one whose outline
    /// for films of no width goes around its centre. Where bubbles of a patch overlap, the last.
    Image<std::uint32_t> ids;
    /// To the nearest point of a film, in pixels, 0 or more: to 1e-6 of itself or of 8 pixels,
    /// whichever is more. Infinite if there is no film. Of a sheared torus the shear is that of the
    /// grid, in whole subpixels.
    Image<float> distance;
    /// The unit vector away from that point; zero where there is none, in a circle's centre.
    Image<float> gradient;
    /// A smooth function that at a film is 0 and has the slope 1, like the distance, and within a
    /// bubble neither creases nor kinks; in pixels, 0 or more. 1 / s² = sum of 1 / phi² over the
    /// bubble's films, phi being that of Biswas and Shapiro, "Approximate distance fields with
    /// non-vanishing gradients" (2004). In the middle of a bubble it is less than the distance, in
    /// a lone bubble of radius R it is (R² - r²) / 2R. Around a patch it is the distance itself.
    Image<float> smooth;
    /// Its gradient, by pixels; its length is 1 at films and 0 in summits.
    Image<float> smooth_gradient;
};

/// All of it comes from the arcs themselves, of the pixel's own bubble alone: the way to the
/// nearest point of a film crosses no other. The same bits for any number of threads; a shift of
/// the grid is an exact cyclic shift of the images. Throws std::invalid_argument as pixels_per_unit
/// does.
DistanceField distance_field(const Frame& frame,
                             const RasterGrid& grid,
                             DistanceNeeds needs,
                             int threads);

/// The same into a field from before, whose memory it uses again.
void write_distance_field(const Frame& frame,
                          const RasterGrid& grid,
                          DistanceNeeds needs,
                          int threads,
                          DistanceField& field);

}  // namespace foam::texgen
