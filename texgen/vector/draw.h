// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/maps/all_maps.h"
#include "texgen/maps/frame_layers.h"
#include "texgen/vector/drawing.h"
#include "texgen/vector/vector_options.h"

#include <string>

namespace foam::texgen {

/// Returns the sRGB colors of all bubbles in the map albedo, as "#rrggbb".
PerBubble<std::string> bubble_colors(const FrameLayers& layers, const AlbedoOptions& options);

/// Draws a frame. The layers are, from bottom to top, "bubbles" (one shape per bubble) or
/// "passages" (one shape; Drawing::background replaces it if bubbles are cut), "films", "walls" or
/// "contours", and "solution". Below a layer of lines that are cut is the layer of their parts
/// beyond the tile, such as "films_beyond". Throws std::invalid_argument if the grid does not fit
/// the domain, or if a color is invalid, and as check_width does.
Drawing draw(FrameLayers& layers,
             VectorContent content,
             const MapOptions& maps,
             const VectorOptions& options);

}  // namespace foam::texgen
