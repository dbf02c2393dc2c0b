// SPDX-License-Identifier: Apache-2.0

#include "texgen/maps/pressure.h"

#include "texgen/image/colormap.h"
#include "texgen/keys/value_kinds.h"
#include "texgen/maps/cell_fill.h"
#include "texgen/maps/neighbor_mean.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <numeric>
#include <span>
#include <stdexcept>
#include <string_view>
#include <utility>
#include <vector>

// The map draws bubbles in flat tones that exaggerate the differences of pressure, like Figure 8 of
// the paper. Percentiles are interpolated between two pressures (definition 7 of R. J. Hyndman and
// Y. Fan, "Sample quantiles in statistical packages", 1996). The scalings Rank and Share are
// histogram equalization (R. C. Gonzalez and R. E. Woods, "Digital Image Processing"), by the
// number and by the area of bubbles. Smoothing and flattening together are a band-pass filter on
// the graph of neighbors, a difference of two averages like that of D. Marr and E. Hildreth
// ("Theory of edge detection", 1980).

namespace foam::texgen {

namespace {

constexpr double kMiddle = 0.5;
// The value of pressure.colormap with which the map stores tones as numbers, not as colors.
constexpr std::string_view kNoColors = "none";

std::span<const std::string_view> colormaps_and_none() {
    static const std::vector<std::string_view> words = [] {
        std::vector<std::string_view> all{kNoColors};
        all.insert(all.end(), colormap_names().begin(), colormap_names().end());
        return all;
    }();
    return words;
}

double tone_in_range(double pressure, double low, double high) {
    return low < high ? (pressure - low) / (high - low) : kMiddle;
}

// Returns a percentile of sorted numbers, interpolated between the two nearest numbers.
// `percentile` is from 0 to 100. Precondition: `sorted` is not empty.
double percentile_of(std::span<const double> sorted, double percentile) {
    const double position = percentile / 100.0 * static_cast<double>(sorted.size() - 1);
    const auto below = static_cast<std::size_t>(position);
    const std::size_t above = std::min(below + 1, sorted.size() - 1);
    return std::lerp(sorted[below], sorted[above], position - static_cast<double>(below));
}

// Returns the rank of a pressure among sorted pressures: 0 for the lowest, 1 for the highest. Equal
// pressures have the mean of their ranks. Between two pressures the rank is interpolated; beyond
// the lowest and highest it is 0 and 1. Precondition: `sorted` is not empty.
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

// Returns the pressures, in increasing order, among which ranks and percentiles are measured. These
// are the pressures at the end of the warm-up. If pressures are smoothed or flattened, they are
// instead the resulting pressures of this frame (`pressures`).
std::vector<double> scale_of(const FrameLayers& layers,
                             const PerBubble<double>& pressures,
                             const PressureOptions& options) {
    if (options.smoothing == 0 && options.flattening == 0) {
        return layers.record().first_pressures;
    }
    std::vector<double> scale = pressures;
    std::sort(scale.begin(), scale.end());
    return scale;
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

// Returns, for each bubble, the total area of the bubbles of lower pressure, divided by the total
// area of all bubbles. Half of the area of the bubble itself, and half of the areas of bubbles of
// the same pressure, count as area of lower pressure.
PerBubble<double> area_shares(const Frame& frame, const PerBubble<double>& pressures) {
    const auto areas = per_bubble<double>(
        frame,
        [&](BubbleId bubble) { return frame.bubbles[bubble].area; },
        [](const LoneBubble& bubble) { return bubble.target_area; });
    std::vector<std::size_t> order(pressures.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
        return std::pair(pressures[a], a) < std::pair(pressures[b], b);
    });
    const double whole = std::accumulate(areas.begin(), areas.end(), 0.0);
    PerBubble<double> shares(pressures.size());
    double lower = 0.0;
    for (std::size_t first = 0; first < order.size();) {
        double equal = 0.0;
        std::size_t last = first;
        for (; last < order.size() && pressures[order[last]] == pressures[order[first]]; ++last) {
            equal += areas[order[last]];
        }
        for (; first < last; ++first) {
            shares[order[first]] = (lower + 0.5 * equal) / whole;
        }
        lower += equal;
    }
    return shares;
}

// Averages pressures with those of neighbors, and subtracts a wider average. This removes
// variations that are narrower than the first average or wider than the second one, so that the
// corridors of a labyrinth are about equally wide.
void smooth_and_flatten(const Frame& frame,
                        const PressureOptions& options,
                        PerBubble<double>& pressures) {
    average_with_neighbors(frame, options.smoothing, pressures);
    if (options.flattening > 0) {
        PerBubble<double> wide = pressures;
        average_with_neighbors(frame, options.flattening, wide);
        std::transform(
            pressures.begin(), pressures.end(), wide.begin(), pressures.begin(), std::minus<>());
    }
}

}  // namespace

Keys<PressureOptions> pressure_keys() {
    using Options = PressureOptions;
    constexpr Choices<PressureScaling, 4> kScalings = {
        {{{"range", PressureScaling::Range},
          {"percentile", PressureScaling::Percentile},
          {"rank", PressureScaling::Rank},
          {"share", PressureScaling::Share}}}};
    return {
        key("scaling",
            kScalings,
            "how pressures become tones. range: by the fixed range low to high. percentile: "
            "linearly between two percentiles of all pressures (pressure.percentile). rank: by the "
            "rank among all pressures. share: by the total area of the bubbles of lower pressure, "
            "divided by the area of all bubbles. percentile and rank use the pressures at the end "
            "of the warm-up (frames.warm_up) or, if pressures are smoothed or flattened, those of "
            "the frame",
            &Options::scaling),
        key("percentile",
            Reals{0.0, 49.0},
            "for \"percentile\": percentage of bubbles beyond each end of the scale",
            &Options::percentile)
            .in("percent of the bubbles")
            .used_with("pressure.scaling", {"percentile"}),
        key("low", kPressures, "for \"range\": pressure of tone 0", &Options::low)
            .in("film tension / sqrt(mean area of the seeded foam or of the drawn frame), "
                "selected by pressure.unit")
            .used_with("pressure.scaling", {"range"})
            .below("high"),
        key("high", kPressures, "for \"range\": pressure of tone 1; above low", &Options::high)
            .in("film tension / sqrt(mean area of the seeded foam or of the drawn frame), "
                "selected by pressure.unit")
            .used_with("pressure.scaling", {"range"}),
        key("unit",
            kPressureUnits,
            "unit of low and high; the same choices as albedo.pressure_unit",
            &Options::unit)
            .used_with("pressure.scaling", {"range"}),
        key("smoothing",
            Integers{0, 1000},
            "rounds in which the pressure of every bubble is averaged with those of its neighbors; "
            "walls of a labyrinth become several bubbles wide",
            &Options::smoothing)
            .in("rounds"),
        key("flattening",
            Integers{0, 1000},
            "further rounds of averaging, after the rounds of smoothing; they give a wider "
            "average, which is subtracted so that the corridors of a labyrinth are about equally "
            "wide; 0 subtracts nothing",
            &Options::flattening)
            .in("rounds"),
        key("exaggeration",
            Reals{0.0, 1000.0},
            "factor on the contrast around the middle tone; a large factor leaves only two tones",
            &Options::exaggeration),
        key("colormap",
            Words{colormaps_and_none()},
            "color map of the tones; with none, the image has one gray channel that stores the "
            "tones",
            &Options::colormap)};
}

const MapTraits& pressure_traits(const PressureOptions& options) {
    return options.colormap == kNoColors ? kPressureMap : kColoredPressureMap;
}

PressureOptions without_colors(PressureOptions options) {
    options.colormap = kNoColors;
    return options;
}

PerBubble<double> pressure_tones(const FrameLayers& layers, const PressureOptions& options) {
    if (!(options.low < options.high)) {
        throw std::invalid_argument(
            fmt::format("pressure.low is {}, but must be below pressure.high, which is {}",
                        options.low,
                        options.high));
    }
    const bool is_range = options.scaling == PressureScaling::Range;
    PerBubble<double> tones = pressures_of(shown_values(layers.frame(), layers.record()),
                                           is_range ? options.unit : PressureUnit::Current);
    smooth_and_flatten(layers.frame(), options, tones);
    if (options.scaling == PressureScaling::Share) {
        tones = area_shares(layers.frame(), tones);
    } else {
        const std::vector<double> scale = scale_of(layers, tones, options);
        for (double& tone : tones) {
            tone = tone_of(tone, scale, options);
        }
    }
    for (double& tone : tones) {
        tone = kMiddle + options.exaggeration * (tone - kMiddle);
    }
    return tones;
}

MapImage draw_pressure(FrameLayers& layers, const PressureOptions& options) {
    const PerBubble<double> tones = pressure_tones(layers, options);
    if (pressure_traits(options).kind == MapKind::Number) {
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
