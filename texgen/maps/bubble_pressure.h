// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/keys/value_kinds.h"
#include "texgen/maps/bubble_values.h"

namespace foam::texgen {

/// The unit of a pressure.
enum class PressureUnit {
    Seed,  // film tension / sqrt(mean area of the seeded foam); this mean area is 1
    // Film tension / sqrt(FoamValues::mean_area): the present mean area of the bubbles, or its
    // average over recent frames. This unit preserves contrast while the foam coarsens.
    Current,
};

inline constexpr Choices<PressureUnit> kPressureUnits = {
    {{{"seed", PressureUnit::Seed}, {"current", PressureUnit::Current}}}};

/// The range of pressures that keys of a preset accept, in either unit.
inline constexpr Reals kPressures{-1e6, 1e6};

/// Returns the pressures of all bubbles in the given unit.
PerBubble<double> pressures_of(const FoamValues& values, PressureUnit unit);

}  // namespace foam::texgen
