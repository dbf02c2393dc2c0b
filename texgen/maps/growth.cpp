// SPDX-License-Identifier: Apache-2.0

#include "texgen/maps/growth.h"

#include "texgen/maps/cell_fill.h"

#include <cmath>
#include <unordered_map>

namespace foam::texgen {

namespace {

// Returns the area of every bubble, by identity.
std::unordered_map<BubbleIdentity, double> areas_of(const Frame& frame) {
    std::unordered_map<BubbleIdentity, double> areas;
    for (const FrameBubble& bubble : frame.bubbles) {
        areas[bubble.identity] = bubble.area;
    }
    for (const LoneBubble& bubble : frame.lone_bubbles) {
        areas[bubble.identity] = bubble.target_area;
    }
    return areas;
}

}  // namespace

Keys<GrowthOptions> growth_keys() {
    return {
        key("full",
            RealsOrAuto{1e-9, 1e6, GrowthOptions().full},
            "growth rate at the value 1 (white) of a PNG, in square foam units per foam time; 0 "
            "(black) stands for -full; \"auto\" fits it to the fastest growth or shrinking in the "
            "whole animation",
            &GrowthOptions::full)
            .in("square foam units per foam time")};
}

NumberPixels draw_growth(FrameLayers& layers, const GrowthOptions& options) {
    const Frame& frame = layers.frame();
    // The time decreases from frame to frame in the second half of a pingpong loop.
    const double time = std::abs(layers.next().time - frame.time);
    const auto next_areas = areas_of(layers.next());
    const auto rate_of = [&](BubbleIdentity bubble, double area) {
        const auto next = next_areas.find(bubble);
        return time > 0.0 ? ((next != next_areas.end() ? next->second : 0.0) - area) / time : 0.0;
    };
    const auto rates = per_bubble<double>(
        frame,
        [&](BubbleId bubble) {
            return rate_of(frame.bubbles[bubble].identity, frame.bubbles[bubble].area);
        },
        [&](const LoneBubble& bubble) { return rate_of(bubble.identity, bubble.target_area); });
    return {fill_numbers(layers, rates), -options.full.value, options.full.value};
}

}  // namespace foam::texgen
