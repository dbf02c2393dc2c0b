#pragma once

#include "core/geometry/vec2.h"

#include <cassert>
#include <cstdint>
#include <vector>

namespace foam {

/// A translation by whole periods of a torus.
struct LatticeOffset {
    std::int32_t i = 0;
    std::int32_t j = 0;

    friend LatticeOffset operator+(LatticeOffset a, LatticeOffset b) {
        return {a.i + b.i, a.j + b.j};
    }
    friend LatticeOffset operator-(LatticeOffset a, LatticeOffset b) {
        return {a.i - b.i, a.j - b.j};
    }
    friend LatticeOffset operator-(LatticeOffset a) { return {-a.i, -a.j}; }
    friend bool operator==(LatticeOffset a, LatticeOffset b) = default;
};

/// A torus: the plane modulo the periods (width, 0) and (shear, height). Its own cell is the
/// rectangle [0, width) x [0, height), whatever the shear. With all periods 0 it is the plane
/// itself, in which nothing wraps and all lattice offsets are zero.
struct Domain {
    double width = 1.0;
    double height = 1.0;
    double shear = 0.0;  // how far the upper neighbour of the cell is moved to the right

    bool is_plane() const { return width == 0.0; }

    /// Precondition: not the plane.
    double area() const {
        assert(!is_plane());
        return width * height;
    }
    Vec2 translation(LatticeOffset offset) const {
        return {offset.i * width + offset.j * shear, offset.j * height};
    }

    /// The offset whose translation, subtracted from the point, brings it into the cell. Zero in
    /// the plane, and along an axis on which the point is no number or 2^31 periods away.
    LatticeOffset cell_of(const Vec2& point) const;

    /// The offsets whose translations lie within a reach of the point along x and along y, and some
    /// more; row by row.
    std::vector<LatticeOffset> offsets_near(const Vec2& point, double reach) const;

    /// The shortest of a vector's copies.
    Vec2 nearest_copy(const Vec2& vector) const;

    /// How far the upper neighbour has moved to the right since an earlier shear of this torus: the
    /// least, as shears are known up to whole widths. 0 in the plane.
    double shear_since(const Domain& earlier) const;
};

inline constexpr Domain kPlane{0.0, 0.0};

}  // namespace foam
