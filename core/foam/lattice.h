// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/foam/foam.h"

#include <cstdint>

namespace foam {

/// A torus, described by a shear whose magnitude is at most half of the width.
struct ReducedLattice {
    Domain domain;
    // The period (shear, height) of the original domain equals the period (shear, height) of
    // `domain` plus `widths` times the period (width, 0).
    std::int32_t widths = 0;

    /// Returns an offset of the original domain as an offset of `domain`.
    LatticeOffset reduced(LatticeOffset offset) const {
        return {offset.i + widths * offset.j, offset.j};
    }
};

/// Returns the same torus with a shear that differs by a whole multiple of the width and has a
/// magnitude of at most half of the width. Returns the plane unchanged. Precondition: the magnitude
/// of the shear, divided by the width, fits into 32 bits.
ReducedLattice reduced_lattice(const Domain& domain);

/// Replaces the domain of a foam by its reduced lattice. No junction moves; only the shear and the
/// lattice offsets change. In the plane, nothing changes.
void reduce_lattice(Foam& foam);

}  // namespace foam
