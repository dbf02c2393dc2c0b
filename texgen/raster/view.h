#pragma once

#include "core/geometry/vec2.h"

namespace foam::texgen {

/// What an image shows of the plane.
struct View {
    Vec2 center{0.0, 0.0};  // shown in the middle of the image; foam units
    double pixels_per_unit = 1.0;

    friend bool operator==(const View& a, const View& b) = default;
};

}  // namespace foam::texgen
