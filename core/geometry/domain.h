// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/geometry/vec2.h"

#include <cassert>
#include <cstdint>
#include <vector>

namespace foam {

/// A translation by whole periods of a torus: i times the period (width, 0) plus j times the period
/// (shear, height) of a Domain.
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

/// The domain of a foam: a torus, or the plane. The torus is the plane modulo its two periods, the
/// vectors (width, 0) and (shear, height). Its fundamental cell is the rectangle
/// [0, width) x [0, height) for any shear. The cell of a lattice offset is the fundamental cell,
/// translated by the offset. If width, height and shear are 0, the domain is the plane: nothing
/// wraps, and all lattice offsets are zero.
struct Domain {
    double width = 1.0;
    double height = 1.0;
    double shear = 0.0;  // shift of each row of cells to the right, relative to the row below

    bool is_plane() const { return width == 0.0; }

    /// Returns the area of the torus. Precondition: the domain is not the plane.
    double area() const {
        assert(!is_plane());
        return width * height;
    }
    /// Returns the offset as a vector.
    Vec2 translation(LatticeOffset offset) const {
        return {offset.i * width + offset.j * shear, offset.j * height};
    }

    /// Returns the lattice offset of the cell that contains the point. The point minus the
    /// translation by this offset is in the fundamental cell, up to rounding. Exception: a
    /// component of the offset is 0 if it would not fit into 32 bits, or if the coordinate from
    /// which it is computed is NaN. In the plane, returns the zero offset.
    LatticeOffset cell_of(const Vec2& point) const;

    /// Returns all offsets whose translations differ from the point by at most `reach` in x and in
    /// y. The result may also contain offsets whose translations are up to one period farther away.
    /// The offsets are ordered by j and then by i. In the plane, returns only the zero offset.
    std::vector<LatticeOffset> offsets_near(const Vec2& point, double reach) const;

    /// Returns the shortest vector that differs from the given vector by whole periods. In the
    /// plane, returns the given vector.
    Vec2 nearest_copy(const Vec2& vector) const;

    /// Returns the change of the shear since an earlier state of this torus. The shear of a torus
    /// is determined only up to multiples of the width. Of the possible changes, the result is the
    /// one of smallest magnitude. In the plane, returns 0.
    double shear_since(const Domain& earlier) const;
};

/// The largest ratio of the width to the height of a torus, and of the height to the width, that is
/// accepted in files and options. On a sheared torus, functions such as nearest_copy take time in
/// proportion to the ratio of width to height. No image has a larger ratio.
inline constexpr double kMaxAspect = 16384.0;

/// Returns true if neither the width nor the height of a torus exceeds the other one by more than
/// the factor kMaxAspect. Precondition: the domain is not the plane.
inline bool has_moderate_shape(const Domain& torus) {
    return torus.width <= kMaxAspect * torus.height && torus.height <= kMaxAspect * torus.width;
}

/// The plane as a domain.
inline constexpr Domain kPlane{0.0, 0.0};

}  // namespace foam
