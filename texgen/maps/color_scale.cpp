// SPDX-License-Identifier: Apache-2.0

#include "texgen/maps/color_scale.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace foam::texgen {

std::vector<LinearRgb> parse_colors(const std::vector<std::string>& colors) {
    std::vector<LinearRgb> parsed;
    parsed.reserve(colors.size());
    for (const std::string& color : colors) {
        parsed.push_back(to_linear(parse_color(color)));
    }
    return parsed;
}

LinearRgb blended(const std::vector<LinearRgb>& colors, double position) {
    const double scaled = std::clamp(position, 0.0, 1.0) * static_cast<double>(colors.size() - 1);
    const auto below = std::min(static_cast<std::size_t>(scaled), colors.size() - 1);
    const auto above = std::min(below + 1, colors.size() - 1);
    const double part = scaled - static_cast<double>(below);
    const auto mix = [&](double a, double b) {
        return srgb_to_linear(std::lerp(linear_to_srgb(a), linear_to_srgb(b), part));
    };
    const LinearRgb& a = colors[below];
    const LinearRgb& b = colors[above];
    return {mix(a.r, b.r), mix(a.g, b.g), mix(a.b, b.b)};
}

LinearRgb picked(const std::vector<LinearRgb>& colors, double position) {
    const double scaled = std::clamp(position, 0.0, 1.0) * static_cast<double>(colors.size());
    return colors[std::min(static_cast<std::size_t>(scaled), colors.size() - 1)];
}

}  // namespace foam::texgen
