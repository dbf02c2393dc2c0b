// SPDX-License-Identifier: Apache-2.0

#include "texgen/maps/bubble_pressure.h"

#include "core/foam/measure.h"
#include "core/foam/statistics.h"

#include <cmath>

namespace foam::texgen {

PerBubble<double> pressures_of(const Frame& frame, PressureUnit unit) {
    const double length = unit == PressureUnit::Seed ? 1.0 : std::sqrt(mean_area(frame));
    const double scale = length / frame.film_tension;
    return per_bubble<double>(
        frame,
        [&](BubbleId bubble) { return frame.bubbles[bubble].pressure * scale; },
        [&](const LoneBubble& bubble) { return frame.film_tension / lone_radius(bubble) * scale; });
}

}  // namespace foam::texgen
