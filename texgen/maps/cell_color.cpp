// SPDX-License-Identifier: Apache-2.0

#include "texgen/maps/cell_color.h"

#include "core/foam/measure.h"
#include "texgen/image/colormap.h"
#include "texgen/maps/identity_number.h"
#include "texgen/maps/mean_bubble.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <stdexcept>

namespace foam::texgen {

namespace {

// Bubbles of three films are at the start of the scale, bubbles of nine films at its end.
constexpr double kFewestSides = 3.0;
constexpr double kMaxSides = 9.0;

PerBubble<double> positions_by_pressure(const Frame& frame, const AlbedoOptions& options) {
    if (!(options.pressure_low < options.pressure_high)) {
        throw std::invalid_argument(
            fmt::format("albedo.pressure_low is {}, but must be below albedo.pressure_high, "
                        "which is {}",
                        options.pressure_low,
                        options.pressure_high));
    }
    PerBubble<double> positions = pressures_of(frame, options.pressure_unit);
    const double range = options.pressure_high - options.pressure_low;
    for (double& position : positions) {
        position = (position - options.pressure_low) / range;
    }
    return positions;
}

// Maps areas to (0, 1) so that the mean area of the frame is the middle of the scale.
PerBubble<double> positions_by_area(const Frame& frame) {
    const double mean = area_of(MeanBubble::Current, frame);
    const auto position = [mean](double area) { return area / (area + mean); };
    return per_bubble<double>(
        frame,
        [&](BubbleId bubble) { return position(frame.bubbles[bubble].area); },
        [&](const LoneBubble& bubble) { return position(bubble.target_area); });
}

PerBubble<double> positions_by_sides(const Frame& frame) {
    const auto position = [](int sides) {
        return (sides - kFewestSides) / (kMaxSides - kFewestSides);
    };
    return per_bubble<double>(
        frame,
        [&](BubbleId bubble) { return position(frame.network.sides(bubble)); },
        [&](const LoneBubble&) { return position(0); });
}

PerBubble<double> numbers_of(const Frame& frame, IdentityStream stream) {
    return per_bubble<double>(
        frame,
        [&](BubbleId bubble) { return identity_number(frame.bubbles[bubble].identity, stream); },
        [&](const LoneBubble& bubble) { return identity_number(bubble.identity, stream); });
}

using ColorScale = std::function<LinearRgb(double)>;

// Returns the color at a position on the scale, interpolated in sRGB, like ColorMap::at.
// Precondition: `position` is from 0 to 1.
LinearRgb blended(const std::vector<LinearRgb>& colors, double position) {
    const double scaled = position * static_cast<double>(colors.size() - 1);
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
    const double scaled = position * static_cast<double>(colors.size());
    return colors[std::min(static_cast<std::size_t>(scaled), colors.size() - 1)];
}

ColorScale color_scale(const AlbedoOptions& options) {
    if (options.colors.empty()) {
        const ColorMap& colormap = find_colormap(options.colormap);
        return [&colormap](double position) { return colormap.at(position); };
    }
    std::vector<LinearRgb> colors;
    for (const std::string& color : options.colors) {
        colors.push_back(to_linear(parse_color(color)));
    }
    const auto color_at = options.color_mix == ColorMix::Blend ? blended : picked;
    return [colors, color_at](double position) {
        return color_at(colors, std::clamp(position, 0.0, 1.0));
    };
}

}  // namespace

PerBubble<double> scale_positions(const Frame& frame, const AlbedoOptions& options) {
    switch (options.color_by) {
        case ColorBy::Pressure:
            return positions_by_pressure(frame, options);
        case ColorBy::Area:
            return positions_by_area(frame);
        case ColorBy::Sides:
            return positions_by_sides(frame);
        default:
            return numbers_of(frame, IdentityStream::First);
    }
}

PerBubble<LinearRgb> cell_colors(const Frame& frame, const AlbedoOptions& options) {
    const ColorScale scale = color_scale(options);
    const PerBubble<double> positions = scale_positions(frame, options);
    const PerBubble<double> numbers = numbers_of(frame, IdentityStream::Second);
    PerBubble<LinearRgb> colors;
    for (std::size_t k = 0; k < positions.size(); ++k) {
        const LinearRgb color = scale(positions[k]);
        const double light = 1.0 + options.variation * (2.0 * numbers[k] - 1.0);
        const auto lit = [light](double part) { return std::clamp(light * part, 0.0, 1.0); };
        colors.push_back({lit(color.r), lit(color.g), lit(color.b)});
    }
    return colors;
}

}  // namespace foam::texgen
