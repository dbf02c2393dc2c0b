#pragma once

#include "texgen/image/color.h"
#include "texgen/maps/albedo_options.h"
#include "texgen/maps/frame_layers.h"
#include "texgen/maps/map_image.h"

#include <cstddef>
#include <functional>

namespace foam::texgen {

/// Returns the fraction of every pixel that films cover, 0 to 1, in one channel. Even films are
/// drawn by exact area. Wet ones end at half their width in the smooth distance (distance.h), which
/// rounds the corners of bubbles; their edges are mixed over the width of a pixel.
Image<float> film_cover(FrameLayers& layers, const AlbedoOptions& options);

/// Returns the fraction that films and bubbles cover together.
Image<float> foam_cover(FrameLayers& layers, const AlbedoOptions& options);
/// Does the same with a known film_cover.
Image<float> foam_cover(FrameLayers& layers,
                        const AlbedoOptions& options,
                        const Image<float>& films);

/// Returns the weight of the shade on bubbles, 0 to 1. Precondition: options.shade > 0.
Image<float> film_shade(FrameLayers& layers, const AlbedoOptions& options);

/// Returns the distances that the functions above need.
DistanceNeeds distance_of_look(const AlbedoOptions& options);

/// Paints films over bubbles whose color at a pixel, counted row by row, is `color_at`. Transparent
/// around a patch, as in fill_colors.
ColorPixels paint_films(FrameLayers& layers,
                        const AlbedoOptions& options,
                        const std::function<LinearRgb(std::size_t)>& color_at);

}  // namespace foam::texgen
