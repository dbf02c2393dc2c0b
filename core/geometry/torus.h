#pragma once

#include "core/geometry/vec2.h"

#include <cassert>
#include <cstdint>

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

/// A rectangular torus: the plane modulo its two periods. With both periods 0 it is the plane
/// itself, in which nothing wraps and all lattice offsets are zero.
struct Torus {
    double width = 1.0;
    double height = 1.0;

    bool is_plane() const { return width == 0.0; }

    /// Precondition: not the plane.
    double area() const {
        assert(!is_plane());
        return width * height;
    }
    Vec2 translation(LatticeOffset offset) const { return {offset.i * width, offset.j * height}; }

    /// The offset whose translation, subtracted from the point, brings it into [0, width) x [0,
    /// height). Zero in the plane.
    LatticeOffset cell_of(const Vec2& point) const;

    /// The shortest of a vector's copies.
    Vec2 nearest_copy(const Vec2& vector) const;
};

inline constexpr Torus kPlane{0.0, 0.0};

}  // namespace foam
