// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/foam/frame.h"
#include "texgen/image/image.h"
#include "texgen/maps/albedo_options.h"
#include "texgen/maps/map.h"
#include "texgen/raster/coords/raster_grid.h"

#include <cstdint>

namespace foam::texgen {

inline constexpr MapTraits kAlbedoMap = {
    .name = "albedo",
    .meaning = "color of bubbles, by pressure or another property, and of films",
    .unit = "light",
    .channels = "R G B",
    .kind = MapKind::Color,
    .smooth_distance = SmoothDistance::UsedByFilms};

/// Draws the colors of bubbles and films. If films have the same width everywhere
/// (FilmProfile::Even) and there is neither shade nor grain, fill_colors (cell_fill.h) draws the
/// map, otherwise paint_films (film_coverage.h) does. Throws the exceptions of cell_colors (for
/// invalid colors) and of cell_arcs (for an invalid film width or grid). Also throws
/// std::invalid_argument if the color of films is invalid, or if a shade is drawn and its color is
/// invalid.
ColorPixels draw_albedo(FrameLayers& layers, const AlbedoOptions& options);

/// Draws the albedo of a single frame and encodes it as 8-bit sRGB. The image has three channels;
/// the image of a patch has a fourth, the opacity. The result does not depend on the number of
/// threads. Throws as draw_albedo does.
Image<std::uint8_t> albedo(const Frame& frame,
                           const RasterGrid& grid,
                           const AlbedoOptions& options,
                           int threads);

}  // namespace foam::texgen
