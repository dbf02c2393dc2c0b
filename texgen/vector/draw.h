// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/maps/all_maps.h"
#include "texgen/maps/frame_layers.h"
#include "texgen/vector/drawing.h"
#include "texgen/vector/vector_options.h"

#include <string>

namespace foam::texgen {

/// Returns the sRGB colors of all bubbles in the map albedo, as "#rrggbb". Throws as cell_colors
/// does.
PerBubble<std::string> bubble_colors(const FrameLayers& layers, const AlbedoOptions& options);

/// Draws a frame. The drawing has these layers, from bottom to top:
///
///     "bubbles"                        only for VectorContent::Foam: one shape per bubble
///     "passages"                       for any other content: all bubbles as one shape
///     "films", "walls" or "contours"   the films, the walls of the maze or the contour lines
///     "solution"                       only for VectorContent::MazeSolution
///
/// If bubbles are cut at the border of the tile of a torus, Drawing::background replaces
/// "passages". If lines are cut there, one more layer, such as "films_beyond", is directly below
/// the layer of these lines. It contains the parts of lines outside of the tile that are so near
/// that their width may reach into the tile. Lines without a width and walls drawn as outlines have
/// no such layer. The title and the description stay empty.
///
/// Throws std::invalid_argument if layers.grid() does not fit the domain (pixels_per_unit). Also
/// throws as bubble_colors, contour_films, check_width and wall_outlines do. Precondition:
/// `content` is not VectorContent::Auto.
Drawing draw(FrameLayers& layers,
             VectorContent content,
             const MapOptions& maps,
             const VectorOptions& options);

}  // namespace foam::texgen
