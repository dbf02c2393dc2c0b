// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/maps/albedo_options.h"
#include "texgen/maps/frame_layers.h"
#include "texgen/maps/map_image.h"
#include "texgen/maps/maze.h"
#include "texgen/maps/thin_film.h"

namespace foam::texgen {

/// The map whose colors the maps lit and emission show.
enum class LitColors { Albedo, ThinFilm, Maze };

/// The colors of a surface. Borrows the options of the maps.
struct SurfaceColors {
    LitColors map;
    const AlbedoOptions& albedo;
    const ThinFilmOptions& thin_film;
    const MazeOptions& maze;
};

/// Draws the colors of a surface without light, as the map `surface.map` shows them.
ColorPixels draw_surface_colors(FrameLayers& layers, const SurfaceColors& surface);

/// Returns the fraction of the color of every pixel that is emitted light, in one channel: `glow`
/// times the coverage of films, or times the weight of the shade beside them
/// (AlbedoOptions::shade), whichever is larger. For LitColors::Maze it is `glow` times the coverage
/// of walls. On the rim of a patch, the coverage of a pixel is divided by the opacity in `colors`,
/// which is the result of draw_surface_colors.
Image<float> glow_fractions(FrameLayers& layers,
                            const SurfaceColors& surface,
                            const ColorPixels& colors,
                            double glow);

}  // namespace foam::texgen
