// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/geometry/vec2.h"

#include <vector>

namespace foam::texgen {

/// A closed polygon whose corners move.
struct BoundaryMotion {
    std::vector<Vec2> points{};   // corners, counter-clockwise
    std::vector<Vec2> motions{};  // the motion of each corner
};

/// Returns the motion of a point within or just outside the polygon, interpolated between the
/// corners by mean value coordinates (Floater 2003, Hormann and Floater 2006). The motion is a
/// smooth function of the point except at the corners of the polygon, and linear along each side.
/// Precondition: the polygon has at least one corner.
Vec2 motion_at(const BoundaryMotion& boundary, const Vec2& point);

}  // namespace foam::texgen
