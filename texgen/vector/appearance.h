// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/maps/all_maps.h"
#include "texgen/maps/frame_layers.h"
#include "texgen/vector/foam_layout.h"
#include "texgen/vector/vector_options.h"

#include <string>
#include <string_view>
#include <vector>

namespace foam::texgen {

/// Returns the content of a drawing: options.content, unless it is VectorContent::Auto. For Auto,
/// returns the content that the first of `maps` shows (Maze, MazeSolution or Contour), or Foam if
/// this map shows none of them. Precondition: `maps` is not empty.
VectorContent shown_content(const VectorOptions& options, const std::vector<std::string>& maps);

/// Returns the word for the content in file names, such as "foam".
std::string_view name_of(VectorContent content);

/// Does nothing if VectorOptions::walls is Lines, because such lines may have the width 0. If it is
/// Outlines, throws std::invalid_argument in these cases:
/// - The lines of the content have no width (check_wall_width).
/// - The content is MazeSolution, and the solution has no width.
/// Precondition: `content` is not Auto.
void check_width(VectorContent content, const MapOptions& maps, const VectorOptions& options);

/// Throws std::invalid_argument if the lines of the content (films, walls or contours) have no
/// width. This is the case if both VectorOptions::wall_width and the width in the options of the
/// map are 0. Does not check the solution of a maze. Precondition: `content` is not Auto.
void check_wall_width(VectorContent content, const MapOptions& maps, const VectorOptions& options);

/// The appearance of the map that a drawing shows: its lines, their color and their width.
struct Appearance {
    std::string layer;         // name of the layer of the lines (Layer::name)
    std::string kind;          // class of the lines (Shape::kind)
    std::string line_color;    // sRGB, "#rrggbb"
    double map_width = 0.0;    // full width of the lines in the map, in pixels
    std::string ground_color;  // color under the lines; empty if bubbles have their own colors
    // Returns true if the map shows a line along the film. May refer to the layers from which
    // appearance_of made it.
    FilmFilter has_line;
};

/// Returns the appearance of the content. The result may refer to `layers`, which must outlive it.
/// Throws std::invalid_argument if the grid of the layers does not fit the domain. For contours,
/// also throws the exceptions of contour_films.
Appearance appearance_of(FrameLayers& layers, VectorContent content, const MapOptions& maps);

/// Returns the full width of lines and walls in millimeters: VectorOptions::wall_width or, if that
/// is 0, the width of the lines in the map.
double drawn_width(const Appearance& look, const Page& page, const VectorOptions& options);

}  // namespace foam::texgen
