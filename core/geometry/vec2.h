// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/geometry/trigonometric.h"

#include <Eigen/Core>

namespace foam {

/// A point or a vector of the plane. Lengths are in foam units (core/README.md) unless stated
/// otherwise. The x axis points right, the y axis points up.
using Vec2 = Eigen::Vector2d;
/// A 2 x 2 matrix.
using Mat2 = Eigen::Matrix2d;

/// Returns the z component of a × b, which is positive if b is to the left of a.
inline double cross(const Vec2& a, const Vec2& b) {
    return a.x() * b.y() - a.y() * b.x();
}

/// Returns the vector of length 1 whose direction is `angle`: radians, counter-clockwise from the x
/// axis.
inline Vec2 unit_vector(double angle) {
    const auto [sine, cosine] = ieee::sincos(angle);
    return {cosine, sine};
}

/// Returns v rotated by 90 degrees counter-clockwise.
inline Vec2 turned_left(const Vec2& v) {
    return {-v.y(), v.x()};
}

}  // namespace foam
