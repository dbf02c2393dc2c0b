// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/image/color.h"
#include "texgen/keys/value_kinds.h"

#include <string>
#include <vector>

namespace foam::texgen {

/// Returns the colors of a list such as {"#ff8000", "#ffffff"}. Throws std::invalid_argument if a
/// color is invalid.
std::vector<LinearRgb> parse_colors(const std::vector<std::string>& colors);

/// A scale of colors with positions.
struct Gradient {
    std::vector<LinearRgb> colors;
    /// The positions of the colors from 0 to 1, in ascending order; empty if the colors are evenly
    /// spaced.
    std::vector<double> positions{};
};

/// Selects the position of the last color of a list if other colors of the list have positions, but
/// the last one has none.
enum class ScaleEnd {
    LastColor,       // the last color is at the position 1
    AfterLastColor,  // the last color is before 1, and covers the rest of the scale, up to 1
};

/// Returns the gradient of a list such as {"#000000", "#ff8000@0.25", "#ffffff"}: a color may be
/// followed by its position. Without a position, the first color is at 0, and `end` selects the
/// position of the last color. Other colors without a position are evenly spaced between the
/// nearest colors with positions. If no color has a position, Gradient::positions is empty. Throws
/// std::invalid_argument if a color or a position is invalid, or if positions descend.
Gradient parse_gradient(const std::vector<std::string>& list, ScaleEnd end);

/// Returns the color at a position on a gradient. Between two colors, it is interpolated in sRGB;
/// before the first color and after the last one, it is constant. Precondition: there is a color.
LinearRgb blended(const Gradient& gradient, double position);

/// Returns the last color whose position is at most `position`, or the first color if there is
/// none. Without positions, each color has an equal part of the scale. Precondition: there is a
/// color.
LinearRgb picked(const Gradient& gradient, double position);

/// The kind of values (value_kinds.h) that are gradients: lists of colors "#rrggbb" or
/// "#rrggbb@position". A single color may be written without brackets.
struct Gradients {
    std::string allowed() const;
    std::string schema() const;
    bool read(const Value& value, std::vector<std::string>& member) const;
    Value write(const std::vector<std::string>& member) const { return ColorLists{}.write(member); }
    std::string fault(const Value& value) const;
};

/// Returns the color at a position on a scale on which the colors are evenly spaced: 0 is the first
/// color, 1 the last. Colors are interpolated in sRGB, like ColorMap::at. Positions are clamped to
/// [0, 1]. Precondition: there is a color.
LinearRgb blended(const std::vector<LinearRgb>& colors, double position);

/// Returns the color at a position on a scale that is divided into equal parts, one per color.
/// Positions are clamped to [0, 1]. Precondition: there is a color.
LinearRgb picked(const std::vector<LinearRgb>& colors, double position);

}  // namespace foam::texgen
