// SPDX-License-Identifier: Apache-2.0

#include "texgen/maps/cell_color.h"

#include "texgen/image/colormap.h"
#include "texgen/maps/bubble_pressure.h"
#include "texgen/maps/color_scale.h"
#include "texgen/maps/identity_number.h"
#include "texgen/maps/picture_color.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <memory>
#include <stdexcept>

namespace foam::texgen {

namespace {

// The numbers of sides of bubbles at the ends of the scale of colors, which are the positions 0 and
// 1. Bubbles of fewer or more sides have positions outside of [0, 1].
constexpr double kSidesAtStart = 3.0;
constexpr double kSidesAtEnd = 9.0;

PerBubble<double> positions_by_pressure(const FoamValues& values, const AlbedoOptions& options) {
    if (!(options.pressure_low < options.pressure_high)) {
        throw std::invalid_argument(
            fmt::format("albedo.pressure_low is {}, but must be below albedo.pressure_high, "
                        "which is {}",
                        options.pressure_low,
                        options.pressure_high));
    }
    PerBubble<double> positions = pressures_of(values, options.pressure_unit);
    const double range = options.pressure_high - options.pressure_low;
    for (double& position : positions) {
        position = (position - options.pressure_low) / range;
    }
    return positions;
}

// Maps areas to (0, 1) so that the mean area is the middle of the scale.
PerBubble<double> positions_by_area(const FoamValues& values) {
    PerBubble<double> positions;
    for (const BubbleValues& bubble : values.bubbles) {
        positions.push_back(bubble.area / (bubble.area + values.mean_area));
    }
    return positions;
}

PerBubble<double> positions_by_sides(const FoamValues& values) {
    PerBubble<double> positions;
    for (const BubbleValues& bubble : values.bubbles) {
        positions.push_back((bubble.sides - kSidesAtStart) / (kSidesAtEnd - kSidesAtStart));
    }
    return positions;
}

// Returns a number in [0, 1) for each bubble, which the bubble keeps for life (identity_number).
PerBubble<double> identity_numbers(const Frame& frame, IdentityStream stream) {
    return per_bubble<double>(
        frame,
        [&](BubbleId bubble) { return identity_number(frame.bubbles[bubble].identity, stream); },
        [&](const LoneBubble& bubble) { return identity_number(bubble.identity, stream); });
}

using ColorScale = std::function<LinearRgb(double)>;

ColorScale color_scale(const AlbedoOptions& options) {
    if (options.colors.empty()) {
        const ColorMap& colormap = find_colormap(options.colormap);
        return [&colormap](double position) { return colormap.at(position); };
    }
    const bool is_blend = options.color_mix == ColorMix::Blend;
    const ScaleEnd end = is_blend ? ScaleEnd::LastColor : ScaleEnd::AfterLastColor;
    return [gradient = parse_gradient(options.colors, end), is_blend](double position) {
        return is_blend ? blended(gradient, position) : picked(gradient, position);
    };
}

// Returns the color at the position of every bubble on the scale.
PerBubble<LinearRgb> scale_colors(const Frame& frame,
                                  const FoamRecord& record,
                                  const AlbedoOptions& options) {
    const ColorScale scale = color_scale(options);
    PerBubble<LinearRgb> colors;
    for (const double position : scale_positions(frame, record, options)) {
        colors.push_back(scale(position));
    }
    return colors;
}

PerBubble<LinearRgb> colors_by_picture(const Frame& frame,
                                       const FrameOne* first,
                                       const AlbedoOptions& options) {
    return first != nullptr
               ? picture_colors(frame, *first, options)
               : picture_colors(frame, FrameOne(std::make_shared<const Frame>(frame)), options);
}

}  // namespace

PerBubble<double> scale_positions(const Frame& frame,
                                  const FoamRecord& record,
                                  const AlbedoOptions& options) {
    switch (options.color_by) {
        case ColorBy::Pressure:
            return positions_by_pressure(shown_values(frame, record), options);
        case ColorBy::Area:
            return positions_by_area(shown_values(frame, record));
        case ColorBy::Sides:
            return positions_by_sides(shown_values(frame, record));
        default:
            return identity_numbers(frame, IdentityStream::First);
    }
}

PerBubble<LinearRgb> cell_colors(const Frame& frame,
                                 const FoamRecord& record,
                                 const AlbedoOptions& options,
                                 const FrameOne* first) {
    PerBubble<LinearRgb> colors = options.color_by == ColorBy::Picture
                                      ? colors_by_picture(frame, first, options)
                                      : scale_colors(frame, record, options);
    const PerBubble<double> numbers = identity_numbers(frame, IdentityStream::Second);
    for (std::size_t k = 0; k < colors.size(); ++k) {
        const LinearRgb color = colors[k];
        const double factor = 1.0 + options.variation * (2.0 * numbers[k] - 1.0);
        const auto scaled = [factor](double light) { return std::clamp(factor * light, 0.0, 1.0); };
        colors[k] = {scaled(color.r), scaled(color.g), scaled(color.b)};
    }
    return colors;
}

}  // namespace foam::texgen
