#pragma once

#include <Eigen/Core>

namespace foam {

/// A point or a vector of the plane, in foam units; x to the right, y up.
using Vec2 = Eigen::Vector2d;
using Mat2 = Eigen::Matrix2d;

/// z component of a × b: positive where b lies to the left of a.
inline double cross(const Vec2& a, const Vec2& b) {
    return a.x() * b.y() - a.y() * b.x();
}

/// v turned left by 90 degrees.
inline Vec2 turned_left(const Vec2& v) {
    return {-v.y(), v.x()};
}

}  // namespace foam
