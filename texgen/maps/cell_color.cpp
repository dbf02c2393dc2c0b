// SPDX-License-Identifier: Apache-2.0

#include "texgen/maps/cell_color.h"

#include "core/foam/measure.h"
#include "texgen/image/colormap.h"
#include "texgen/maps/identity_number.h"
#include "texgen/maps/mean_bubble.h"

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

PerBubble<double> tones_by_pressure(const Frame& frame, const AlbedoOptions& options) {
    if (!(options.pressure_low < options.pressure_high)) {
        throw std::invalid_argument("the low end of the pressures must be below the high end");
    }
    PerBubble<double> tones = pressures_of(frame, options.pressure_unit);
    const double range = options.pressure_high - options.pressure_low;
    for (double& tone : tones) {
        tone = (tone - options.pressure_low) / range;
    }
    return tones;
}

// Maps areas to (0, 1) so that the mean area of the frame is the middle of the scale.
PerBubble<double> tones_by_area(const Frame& frame) {
    const double mean = area_of(MeanBubble::Current, frame);
    const auto tone = [mean](double area) { return area / (area + mean); };
    return per_bubble<double>(
        frame,
        [&](BubbleId bubble) { return tone(frame.bubbles[bubble].area); },
        [&](const LoneBubble& bubble) { return tone(bubble.target_area); });
}

PerBubble<double> tones_by_sides(const Frame& frame) {
    const auto tone = [](int sides) { return (sides - kFewestSides) / (kMaxSides - kFewestSides); };
    return per_bubble<double>(
        frame,
        [&](BubbleId bubble) { return tone(frame.network.sides(bubble)); },
        [&](const LoneBubble&) { return tone(0); });
}

PerBubble<double> numbers_of(const Frame& frame, IdentityStream stream) {
    return per_bubble<double>(
        frame,
        [&](BubbleId bubble) { return identity_number(frame.bubbles[bubble].identity, stream); },
        [&](const LoneBubble& bubble) { return identity_number(bubble.identity, stream); });
}

using ColorOfTone = std::function<LinearRgb(double)>;

// Interpolates between colors in sRGB, like ColorMap::at.
LinearRgb blended(const std::vector<LinearRgb>& colors, double tone) {
    const double position = tone * static_cast<double>(colors.size() - 1);
    const auto below = std::min(static_cast<std::size_t>(position), colors.size() - 1);
    const auto above = std::min(below + 1, colors.size() - 1);
    const double part = position - static_cast<double>(below);
    const auto mix = [&](double a, double b) {
        return srgb_to_linear(std::lerp(linear_to_srgb(a), linear_to_srgb(b), part));
    };
    const LinearRgb& a = colors[below];
    const LinearRgb& b = colors[above];
    return {mix(a.r, b.r), mix(a.g, b.g), mix(a.b, b.b)};
}

LinearRgb picked(const std::vector<LinearRgb>& colors, double tone) {
    const double position = tone * static_cast<double>(colors.size());
    return colors[std::min(static_cast<std::size_t>(position), colors.size() - 1)];
}

ColorOfTone color_of_tone(const AlbedoOptions& options) {
    if (options.colors.empty()) {
        const ColorMap& colormap = find_colormap(options.colormap);
        return [&colormap](double tone) { return colormap.at(tone); };
    }
    std::vector<LinearRgb> colors;
    for (const std::string& color : options.colors) {
        colors.push_back(to_linear(parse_color(color)));
    }
    const auto of_tone = options.color_mix == ColorMix::Blend ? blended : picked;
    return [colors, of_tone](double tone) { return of_tone(colors, std::clamp(tone, 0.0, 1.0)); };
}

}  // namespace

PerBubble<double> tones_of(const Frame& frame, const AlbedoOptions& options) {
    switch (options.color_by) {
        case ColorBy::Pressure:
            return tones_by_pressure(frame, options);
        case ColorBy::Area:
            return tones_by_area(frame);
        case ColorBy::Sides:
            return tones_by_sides(frame);
        default:
            return numbers_of(frame, IdentityStream::First);
    }
}

PerBubble<LinearRgb> cell_colors(const Frame& frame, const AlbedoOptions& options) {
    const ColorOfTone color_of = color_of_tone(options);
    const PerBubble<double> tones = tones_of(frame, options);
    const PerBubble<double> numbers = numbers_of(frame, IdentityStream::Second);
    PerBubble<LinearRgb> colors;
    for (std::size_t k = 0; k < tones.size(); ++k) {
        const LinearRgb color = color_of(tones[k]);
        const double light = 1.0 + options.variation * (2.0 * numbers[k] - 1.0);
        const auto lit = [light](double part) { return std::clamp(light * part, 0.0, 1.0); };
        colors.push_back({lit(color.r), lit(color.g), lit(color.b)});
    }
    return colors;
}

}  // namespace foam::texgen
