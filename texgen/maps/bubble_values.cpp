// SPDX-License-Identifier: Apache-2.0

#include "texgen/maps/bubble_values.h"

#include "core/foam/measure.h"
#include "texgen/maps/mean_bubble.h"

#include <cmath>

namespace foam::texgen {

namespace {

// Maps a pressure to (-1, 1).
double compressed(double pressure) {
    return pressure / (1.0 + std::abs(pressure));
}

// The inverse of `compressed`.
double expanded(double value) {
    return value / (1.0 - std::abs(value));
}

}  // namespace

FoamValues present_values(const Frame& frame) {
    const double per_tension = 1.0 / frame.film_tension;
    return {per_bubble<BubbleValues>(
                frame,
                [&](BubbleId bubble) {
                    const FrameBubble& one = frame.bubbles[bubble];
                    return BubbleValues{one.pressure * per_tension,
                                        one.area,
                                        static_cast<double>(frame.network.sides(bubble))};
                },
                [&](const LoneBubble& bubble) {
                    return BubbleValues{1.0 / lone_radius(bubble), bubble.target_area, 0.0};
                }),
            area_of(MeanBubble::Current, frame)};
}

FoamValues shown_values(const Frame& frame, const FoamRecord& record) {
    if (record.averages.bubbles.empty()) {
        return present_values(frame);
    }
    const double length = std::sqrt(record.averages.mean_area);
    const auto averages_of = [&](BubbleIdentity bubble) {
        BubbleValues values = record.averages.bubbles.at(bubble);
        values.pressure = expanded(values.pressure) / length;
        return values;
    };
    return {per_bubble<BubbleValues>(
                frame,
                [&](BubbleId bubble) { return averages_of(frame.bubbles[bubble].identity); },
                [&](const LoneBubble& bubble) { return averages_of(bubble.identity); }),
            record.averages.mean_area};
}

FoamValues values_to_average(const Frame& frame) {
    FoamValues values = present_values(frame);
    const double length = std::sqrt(values.mean_area);
    for (BubbleValues& bubble : values.bubbles) {
        bubble.pressure = compressed(bubble.pressure * length);
    }
    return values;
}

}  // namespace foam::texgen
