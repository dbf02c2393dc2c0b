// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/vector/chain.h"

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace foam::texgen {

/// The appearance of shapes. Colors are sRGB, "#rrggbb"; an empty color draws nothing.
struct Style {
    std::string fill{};
    std::string stroke{};
    double stroke_width = 0.0;  // millimeters
};

/// A part of a drawing. The inside of a filled shape is the region in which the winding number of
/// its closed chains is not zero (the fill rule "nonzero" of SVG). A clockwise chain inside of a
/// counter-clockwise chain is therefore a hole.
struct Shape {
    std::string kind;  // the class of the shape in an SVG, such as "bubble"
    std::string id{};  // unique in the drawing; may be empty
    std::vector<Chain> chains;
    std::string fill{};  // replaces the color Style::fill of the layer, unless empty
    // Names and values of further data, such as {"sides", "6"}.
    std::vector<std::pair<std::string, std::string>> data{};
};

/// Shapes of one kind, which are drawn in their order.
struct Layer {
    std::string name;
    Style style{};
    std::vector<Shape> shapes{};
    // True for lines and walls that plotters and cutters follow; false for bubbles, for the ground,
    // and for parts of lines beyond the tile.
    bool is_tool_path = false;
    // True if the shapes are those parts of lines that are outside of the tile. They are drawn
    // because half of their stroke may reach into the tile.
    bool is_beyond_tile = false;
};

/// A drawing of a frame. Lengths are in millimeters. The origin is the lower left corner of the
/// tile or of the view, y points up.
struct Drawing {
    double width = 0.0;   // width of the tile or of the view
    double height = 0.0;  // height of the tile or of the view
    // The box that the page shows if bubbles are drawn whole and extend beyond the tile
    // (VectorWrap::Whole); nullopt if the page shows the tile or the view.
    std::optional<Box> extended{};
    double scale = 1.0;  // millimeters per foam unit
    std::string title{};
    std::string description{};
    std::string background{};     // color of the whole drawing; empty for none
    std::vector<Layer> layers{};  // from bottom to top
    std::vector<Vec2> junctions{};

    /// Returns the box that the page shows.
    Box page_box() const { return extended.value_or(Box{{0.0, 0.0}, {width, height}}); }
};

}  // namespace foam::texgen
