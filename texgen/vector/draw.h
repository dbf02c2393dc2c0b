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
///     "bubbles"                        only for Foam: one shape per bubble
///     "passages"                       not for Foam: all bubbles as one shape; if bubbles are cut,
///                                      Drawing::background replaces this layer
///     "films", "walls" or "contours"   the lines of the content
///     "solution"                       only for MazeSolution
///
/// Below a layer of lines that are cut is the layer of their parts beyond the tile, such as
/// "films_beyond". Lines without a width and walls drawn as outlines have no such layer. The title
/// and the description stay empty. Throws std::invalid_argument if the grid does not fit the
/// domain. Also throws as bubble_colors, contour_films, check_width and wall_outlines do.
/// Precondition: `content` is not Auto.
Drawing draw(FrameLayers& layers,
             VectorContent content,
             const MapOptions& maps,
             const VectorOptions& options);

}  // namespace foam::texgen
