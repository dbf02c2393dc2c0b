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
/// 0) and (shear, height). Its own cell is the rectangle [0, width) x [0, height) for any shear. If
/// all periods are 0, the domain is the plane, in which nothing wraps and all lattice offsets are
/// zero.
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

    /// The offset whose translation, subtracted from the point, brings it into the cell. Zero in
    /// the plane, and along an axis on which the point is no number or 2^31 periods away.
    LatticeOffset cell_of(const Vec2& point) const;

    /// Returns, row by row, the offsets whose translations are within `reach` of the point along x
    /// and along y. May return some more. Returns only the zero offset in the plane.
    std::vector<LatticeOffset> offsets_near(const Vec2& point, double reach) const;

    /// Returns the shortest copy of a vector modulo the periods.
    Vec2 nearest_copy(const Vec2& vector) const;

    /// Returns how far the upper neighbor of the cell has moved to the right since an earlier shear
    /// of this torus. A shear is known up to whole widths: the result has the smallest magnitude.
    /// Returns 0 in the plane.
    double shear_since(const Domain& earlier) const;
};

/// The plane.
inline constexpr Domain kPlane{0.0, 0.0};

}  // namespace foam
