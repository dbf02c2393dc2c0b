#pragma once

#include "texgen/image/color.h"
#include "texgen/maps/albedo.h"
#include "texgen/maps/frame_layers.h"
#include "texgen/maps/map_image.h"

#include <cstddef>
#include <functional>

namespace foam::texgen {

/// The part of every pixel that films cover, 0 to 1, in one channel. Even films are drawn by exact
/// area. Wet ones reach as far as half their width in the smooth distance (distance.h), which
/// rounds the corners of bubbles; their edges are mixed over the width of a pixel.
Image<float> film_cover(FrameLayers& layers, const AlbedoOptions& options);

/// The part that films and bubbles cover together.
Image<float> foam_cover(FrameLayers& layers, const AlbedoOptions& options);
/// The same where film_cover is known.
Image<float> foam_cover(FrameLayers& layers,
                        const AlbedoOptions& options,
                        const Image<float>& films);

/// The weight of the shade on bubbles, 0 to 1. Precondition: there is one.
Image<float> film_shade(FrameLayers& layers, const AlbedoOptions& options);

/// What these ask of distances.
DistanceNeeds distance_of_look(const AlbedoOptions& options);

/// Films over bubbles whose colour at a pixel's place, row by row, is `color_at`. Transparent
/// around a patch, as fill_colors makes it.
ColorPixels paint_films(FrameLayers& layers,
                        const AlbedoOptions& options,
                        const std::function<LinearRgb(std::size_t)>& color_at);

}  // namespace foam::texgen
