// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/maps/albedo_options.h"
#include "texgen/maps/frame_layers.h"
#include "texgen/maps/map_image.h"
#include "texgen/maps/maze.h"
#include "texgen/maps/thin_film.h"

namespace foam::texgen {

/// Selects the map whose colors are shown by two other maps, `lit` and `emission`.
enum class LitColors { Albedo, ThinFilm, Maze };

/// The colors of a surface. Borrows the options of the maps.
struct SurfaceColors {
    LitColors map;
    const AlbedoOptions& albedo;
    const ThinFilmOptions& thin_film;
    const MazeOptions& maze;
};

/// Draws the unlit colors of a surface, as the map `surface.map` shows them. Throws as the function
/// that draws this map does (draw_albedo, draw_thin_film or draw_maze).
ColorPixels draw_surface_colors(FrameLayers& layers, const SurfaceColors& surface);

/// Returns, in one channel, the fraction of the color of each pixel that is emitted as light. The
/// fraction is `glow` (LitOptions::glow) times a weight. The weight is the larger of two numbers:
/// the coverage of films, and the weight of the shade beside them (film_shade). For LitColors::Maze
/// the weight is the coverage of walls. In a patch, the weight is divided by the opacity of the
/// pixel and limited to 1. `colors` is the result of draw_surface_colors.
Image<float> glow_fractions(FrameLayers& layers,
                            const SurfaceColors& surface,
                            const ColorPixels& colors,
                            double glow);

}  // namespace foam::texgen
