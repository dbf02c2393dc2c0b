#pragma once

#include "texgen/image/color.h"
#include "texgen/maps/albedo.h"
#include "texgen/maps/frame_layers.h"
#include "texgen/maps/map_image.h"

#include <cstddef>
#include <functional>

namespace foam::texgen {

/// How much of every pixel films take, in one channel each, 0 to 1.
struct FilmLook {
    Image<float> films;  // the part that films cover
    Image<float> foam;   // the part that films and bubbles cover together
    Image<float> shade;  // the weight of the shade on bubbles; empty if there is none
};

/// Even films are drawn by exact area. Wet ones reach as far as half their width in the smooth
/// distance (distance.h), which rounds the corners of bubbles; their edges are mixed over the width
/// of a pixel.
FilmLook film_look(FrameLayers& layers, const AlbedoOptions& options);

/// What it asks of distances.
DistanceNeeds distance_of_look(const AlbedoOptions& options);

/// Films over bubbles whose colour at a pixel's place, row by row, is `color_at`. Transparent
/// around a patch, as fill_colors makes it.
ColorPixels paint_films(FrameLayers& layers,
                        const FilmLook& look,
                        const LinearRgb& film,
                        const std::function<LinearRgb(std::size_t)>& color_at);

}  // namespace foam::texgen
