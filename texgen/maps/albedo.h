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
    .smooth_distance = SmoothDistance::UsedByFilms};

/// Draws the colors of bubbles and films. It uses fill_colors for even films without a shade, and
/// paint_films for wet films and for shades. Throws as cell_colors does, and std::invalid_argument
/// for an invalid color of films or of the shade.
ColorPixels draw_albedo(FrameLayers& layers, const AlbedoOptions& options);

/// Draws the albedo of a single frame and encodes it as sRGB. The result does not depend on the
/// number of threads. Throws as draw_albedo and cell_arcs do.
Image<std::uint8_t> albedo(const Frame& frame,
                           const RasterGrid& grid,
                           const AlbedoOptions& options,
                           int threads);

}  // namespace foam::texgen
