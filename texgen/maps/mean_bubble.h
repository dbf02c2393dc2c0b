#pragma once

#include "core/foam/frame.h"

namespace foam::texgen {

/// The bubble that areas and lengths are measured by.
enum class MeanBubble {
    Seed,     // of the mean area of the seeded foam, which is 1
    Current,  // of the mean area of the frame: what is measured keeps its look while a foam
              // coarsens
};

/// Its area in foam units; above 0.
double area_of(MeanBubble bubble, const Frame& frame);

/// The diameter of a circle of that area.
double diameter_of(MeanBubble bubble, const Frame& frame);

}  // namespace foam::texgen
