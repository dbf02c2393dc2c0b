// SPDX-License-Identifier: Apache-2.0

#include "texgen/maps/pressure.h"

#include "texgen/image/colormap.h"
#include "texgen/keys/value_kinds.h"
#include "texgen/maps/cell_fill.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>
#include <stdexcept>
#include <string_view>
#include <vector>

namespace foam::texgen {

namespace {

constexpr double kMiddle = 0.5;

std::span<const std::string_view> colormaps_and_none() {
    static const std::vector<std::string_view> words = [] {
        std::vector<std::string_view> all{"none"};
        all.insert(all.end(), colormap_names().begin(), colormap_names().end());
        return all;
    }();
    return words;
}

double tone_in_range(double pressure, double low, double high) {
    return low < high ? (pressure - low) / (high - low) : kMiddle;
}

// Returns a percentile of sorted numbers, interpolated between two of them. Precondition: `sorted`
// is not empty.
double percentile_of(std::span<const double> sorted, double percentile) {
    const double position = percentile / 100.0 * static_cast<double>(sorted.size() - 1);
    const auto below = static_cast<std::size_t>(position);
    const std::size_t above = std::min(below + 1, sorted.size() - 1);
    return std::lerp(sorted[below], sorted[above], position - static_cast<double>(below));
}

// Returns the rank of a pressure among sorted pressures: 0 for the lowest, 1 for the highest. Equal
// pressures have the mean of their ranks. Between two pressures the rank is interpolated.
double rank_among(std::span<const double> sorted, double pressure) {
    const auto [first, last] = std::equal_range(sorted.begin(), sorted.end(), pressure);
    const auto lower = static_cast<double>(first - sorted.begin());
    const auto not_higher = static_cast<double>(last - sorted.begin());
    const auto steps = static_cast<double>(sorted.size() - 1);
    if (first != last) {
        return steps > 0.0 ? 0.5 * (lower + not_higher - 1.0) / steps : kMiddle;
    }
    if (first == sorted.begin() || first == sorted.end()) {
        return first == sorted.begin() ? 0.0 : 1.0;
    }
    const double below = *(first - 1);
    return (lower - 1.0 + (pressure - below) / (*first - below)) / steps;
}

double tone_of(double pressure, std::span<const double> scale, const PressureOptions& options) {
    if (options.scaling == PressureScaling::Range) {
        return tone_in_range(pressure, options.low, options.high);
    }
    if (scale.empty()) {
        return kMiddle;
    }
    if (options.scaling == PressureScaling::Rank) {
        return rank_among(scale, pressure);
    }
    return tone_in_range(pressure,
                         percentile_of(scale, options.percentile),
                         percentile_of(scale, 100.0 - options.percentile));
}

PerBubble<double> tones_of(const FrameLayers& layers, const PressureOptions& options) {
    const bool own_unit = options.scaling == PressureScaling::Range;
    PerBubble<double> tones =
        pressures_of(layers.frame(), own_unit ? options.unit : PressureUnit::Current);
    for (double& tone : tones) {
        tone = tone_of(tone, layers.record().first_pressures, options);
        tone = kMiddle + options.exaggeration * (tone - kMiddle);
    }
    return tones;
}

}  // namespace

Keys<PressureOptions> pressure_keys() {
    using Options = PressureOptions;
    constexpr Choices<PressureScaling, 3> kScalings = {
        {{{"range", PressureScaling::Range},
          {"percentile", PressureScaling::Percentile},
          {"rank", PressureScaling::Rank}}}};
    return {
        key("scaling",
            kScalings,
            "how pressures become tones: by a fixed range, by a percentile range of the first "
            "frame, or by rank among the bubbles of the first frame",
            &Options::scaling),
        key("percentile",
            Reals{0.0, 49.0},
            "for \"percentile\": percentage of bubbles excluded at each end",
            &Options::percentile)
            .in("percent of the bubbles"),
        key("low", kPressures, "for \"range\": pressure of tone 0", &Options::low)
            .in("film tension / sqrt(mean area), selected by pressure.unit")
            .below("high"),
        key("high", kPressures, "for \"range\": pressure of tone 1; above low", &Options::high)
            .in("film tension / sqrt(mean area), selected by pressure.unit"),
        key("unit",
            kPressureUnits,
            "unit of low and high, as albedo.pressure_unit",
            &Options::unit),
        key("exaggeration",
            Reals{0.0, 1000.0},
            "factor on the contrast around the middle tone; a large factor leaves only two tones",
            &Options::exaggeration),
        key("colormap",
            Words{colormaps_and_none()},
            "colors of the tones; none writes gray numbers",
            &Options::colormap)};
}

MapImage draw_pressure(FrameLayers& layers, const PressureOptions& options) {
    if (!(options.low < options.high)) {
        throw std::invalid_argument("the low end of the pressures must be below the high end");
    }
    const PerBubble<double> tones = tones_of(layers, options);
    if (options.colormap == "none") {
        return NumberPixels{fill_numbers(layers, tones), 0.0, 1.0};
    }
    const ColorMap& colormap = find_colormap(options.colormap);
    PerBubble<LinearRgb> colors;
    for (const double tone : tones) {
        colors.push_back(colormap.at(tone));
    }
    return fill_colors(layers, colors, {}, 0.0);
}

}  // namespace foam::texgen
