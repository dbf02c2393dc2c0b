// SPDX-License-Identifier: Apache-2.0

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

/// The domain of a foam: a torus, or the plane. The torus is the plane modulo the periods (width,
/// 0) and (shear, height). Its own cell, the lattice cell of offset zero, is the rectangle [0,
/// width) x [0, height) for any shear. If all periods are 0, the domain is the plane, in which
/// nothing wraps and all lattice offsets are zero.
struct Domain {
    double width = 1.0;
    double height = 1.0;
    double shear = 0.0;  // how far the upper neighbor of the cell is shifted to the right

    bool is_plane() const { return width == 0.0; }

    /// Returns the area of the torus. Precondition: the domain is not the plane.
    double area() const {
        assert(!is_plane());
        return width * height;
    }
    /// Returns the translation by the periods of the offset.
    Vec2 translation(LatticeOffset offset) const {
        return {offset.i * width + offset.j * shear, offset.j * height};
    }

    /// Returns the lattice offset of the cell that contains the point: the point minus its
    /// translation is in the torus' own cell. A component of the offset is 0 if it would not fit 32
    /// bits or if the coordinate is NaN. Returns zero in the plane.
    LatticeOffset cell_of(const Vec2& point) const;

    /// Returns, row by row, the offsets whose translations are within `reach` of the point along x
    /// and along y. May also return offsets slightly farther away. Returns only the zero offset in
    /// the plane.
    std::vector<LatticeOffset> offsets_near(const Vec2& point, double reach) const;

    /// Returns the shortest copy of a vector modulo the periods.
    Vec2 nearest_copy(const Vec2& vector) const;

    /// Returns the change of the shear since an earlier state of this torus. A shear is determined
    /// up to multiples of the width; the result is the change of smallest magnitude. Returns 0 in
    /// the plane.
    double shear_since(const Domain& earlier) const;
};

/// The plane.
inline constexpr Domain kPlane{0.0, 0.0};

}  // namespace foam
