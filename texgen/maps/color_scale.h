// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/image/color.h"

#include <string>
#include <vector>

namespace foam::texgen {

/// Returns the colors of a list such as {"#ff8000", "#ffffff"}. Throws std::invalid_argument if a
/// color is invalid.
std::vector<LinearRgb> parse_colors(const std::vector<std::string>& colors);

/// Returns the color at a position on a scale on which the colors are evenly spaced: 0 is the first
/// color, 1 the last. Colors are interpolated in sRGB, like ColorMap::at. Positions are clamped to
/// [0, 1]. Precondition: there is a color.
LinearRgb blended(const std::vector<LinearRgb>& colors, double position);

/// Returns the color at a position on a scale that is divided into equal parts, one per color.
/// Positions are clamped to [0, 1]. Precondition: there is a color.
LinearRgb picked(const std::vector<LinearRgb>& colors, double position);

}  // namespace foam::texgen
