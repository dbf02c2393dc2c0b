// SPDX-License-Identifier: Apache-2.0

#include "texgen/maps/bubble_pressure.h"

#include <cmath>

namespace foam::texgen {

PerBubble<double> pressures_of(const FoamValues& values, PressureUnit unit) {
    const double length = unit == PressureUnit::Seed ? 1.0 : std::sqrt(values.mean_area);
    PerBubble<double> pressures;
    for (const BubbleValues& bubble : values.bubbles) {
        pressures.push_back(bubble.pressure * length);
    }
    return pressures;
}

}  // namespace foam::texgen
