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

/// Points and their motions. The arrays `x` and `y` have the same size. set_motions gives this size
/// to the other two arrays.
struct MovingPoints {
    std::vector<double> x;
    std::vector<double> y;
    std::vector<double> motion_x;
    std::vector<double> motion_y;
};

/// Sets the motions of points within or just outside the polygon, interpolated between the corners
/// by mean value coordinates (Floater 2003, Hormann and Floater 2006). The motion is a smooth
/// function of the point except at the corners of the polygon, and linear along each side.
/// Preconditions: the polygon has at least one corner, and its corners and the points have the same
/// origin and the same unit of length.
void set_motions(const BoundaryMotion& boundary, MovingPoints& points);

}  // namespace foam::texgen
