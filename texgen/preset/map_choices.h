#pragma once

#include "texgen/preset/value_kinds.h"

namespace foam::texgen {

// What keys of several maps allow.

inline constexpr double kLargestPressure = 1e6;

inline constexpr Choices<PressureUnit> kPressureUnits = {
    {{{"seed", PressureUnit::Seed}, {"current", PressureUnit::Current}}}};

inline constexpr Choices<MeanBubble> kMeanBubbles = {
    {{{"seed", MeanBubble::Seed}, {"current", MeanBubble::Current}}}};

}  // namespace foam::texgen
