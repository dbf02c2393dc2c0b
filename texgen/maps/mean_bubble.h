#pragma once

#include "core/foam/frame.h"
#include "texgen/keys/value_kinds.h"

namespace foam::texgen {

/// The bubble that areas and lengths are measured by.
enum class MeanBubble {
    Seed,     // of the mean area of the seeded foam, which is 1
    Current,  // of the mean area of the frame, so that maps keep their look while a foam coarsens
};

inline constexpr Choices<MeanBubble> kMeanBubbles = {
    {{{"seed", MeanBubble::Seed}, {"current", MeanBubble::Current}}}};

/// Returns its area in foam units, which is above 0.
double area_of(MeanBubble bubble, const Frame& frame);

/// Returns the diameter of a circle of that area.
double diameter_of(MeanBubble bubble, const Frame& frame);

}  // namespace foam::texgen
