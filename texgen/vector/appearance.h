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

/// Returns what a drawing shows, given the maps of a preset (image.maps): options.content, unless
/// it is VectorContent::Auto. Does not return VectorContent::Auto.
VectorContent shown_content(const VectorOptions& options, const std::vector<std::string>& maps);

/// Returns the word for the content in file names, such as "foam".
std::string_view name_of(VectorContent content);

/// Throws std::invalid_argument if walls are drawn as outlines, but have no width.
void check_width(VectorContent content, const MapOptions& maps, const VectorOptions& options);

/// Throws std::invalid_argument if lines have no width. Does not check the solution of a maze.
void check_wall_width(VectorContent content, const MapOptions& maps, const VectorOptions& options);

/// The appearance of the map that a drawing shows: its lines, their color and their width.
struct Appearance {
    std::string layer;  // name of the layer of the lines
    std::string kind;   // class of the lines
    std::string line_color;
    double map_width = 0.0;    // width of the lines in the map, in pixels
    std::string ground_color;  // empty if bubbles have colors
    FilmFilter has_line;       // may refer to the layers
};

/// Returns the appearance of the map. Throws std::invalid_argument if the grid of the layers does
/// not fit the domain.
Appearance appearance_of(FrameLayers& layers, VectorContent content, const MapOptions& maps);

/// Returns the full width of lines and walls in millimeters.
double drawn_width(const Appearance& look, const Page& page, const VectorOptions& options);

}  // namespace foam::texgen
