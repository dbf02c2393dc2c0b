#pragma once

#include "core/geometry/vec2.h"

#include <vector>

namespace foam::texgen {

/// A closed polygon whose corners move.
struct BoundaryMotion {
    std::vector<Vec2> points{};  // counter-clockwise
    std::vector<Vec2> ways{};    // as many
};

/// Returns the motion of a point within or just outside the polygon: smooth there, and linear from
/// corner to corner on the polygon. Mean value coordinates (Floater 2003, Hormann and Floater
/// 2006). Precondition: there are corners.
Vec2 motion_at(const BoundaryMotion& boundary, const Vec2& point);

}  // namespace foam::texgen
