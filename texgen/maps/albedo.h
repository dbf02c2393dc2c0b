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
    .shows_films = true};

/// Draws the colors of bubbles and films. If films have the same width everywhere
/// (FilmProfile::Even) and there is neither shade nor grain, fill_colors (cell_fill.h) draws the
/// map, otherwise paint_films (film_coverage.h) does. Throws the exceptions of cell_colors (for
/// invalid colors) and of cell_arcs (for an invalid film width or grid). Also throws
/// std::invalid_argument if the color of films is invalid, or if a shade is drawn and its color is
/// invalid.
ColorPixels draw_albedo(FrameLayers& layers, const AlbedoOptions& options);

}  // namespace foam::texgen
