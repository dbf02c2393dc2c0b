// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/foam/frame.h"
#include "texgen/keys/value_kinds.h"

namespace foam::texgen {

/// The choices for the mean bubble, a circle whose area and diameter serve as units of areas and
/// lengths in some maps.
enum class MeanBubble {
    Seed,     // has the mean area of the seeded foam, which is 1
    Current,  // has the mean area of the frame, so that maps keep their look while a foam coarsens
};

inline constexpr Choices<MeanBubble> kMeanBubbles = {
    {{{"seed", MeanBubble::Seed}, {"current", MeanBubble::Current}}}};

/// Returns the area of a mean bubble in square foam units; 1 if the frame has no bubbles.
double area_of(MeanBubble bubble, const Frame& frame);

/// Returns the diameter of a circle that has the area of a mean bubble, in foam units.
double diameter_of(MeanBubble bubble, const Frame& frame);

}  // namespace foam::texgen
