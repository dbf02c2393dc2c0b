// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/network/network.h"

#include <algorithm>
#include <cstdint>
#include <optional>
#include <string>

namespace foam {

/// The largest number of periods, along either axis, that the lattice offset of a film may have.
/// The limit also applies to the sum of the offsets along the loop of a bubble, from its first
/// half-edge to any other. Sums of two offsets within this limit do not overflow.
inline constexpr std::int32_t kMaxPeriods = 1'000'000;

/// Returns true if a component of the offset exceeds kMaxPeriods in magnitude.
constexpr bool exceeds_max_periods(LatticeOffset offset) {
    return std::max(offset.i, offset.j) > kMaxPeriods ||
           std::min(offset.i, offset.j) < -kMaxPeriods;
}

/// Returns a description of the first broken invariant, or nothing if the network is valid. The
/// invariants, for V junctions, E films and F bubbles (without the ghost), are:
/// - exactly three half-edges of live films leave each junction;
/// - next(), left(), tail(), first() and outgoing() are consistent with each other (first() of the
///   ghost is not checked);
/// - every bubble has at least two sides, and the loop around it closes after sides() half-edges;
/// - the lattice offsets of the half-edges around a bubble add up to zero, so that the bubble is a
///   disc;
/// - no lattice offset, and no sum of the offsets along a loop, exceeds kMaxPeriods;
/// - no film has the same copy of a bubble, or the ghost, on both sides;
/// - the numbers of sides of all bubbles and of the ghost add up to 2 E, and 3 V = 2 E;
/// - in the plane, all lattice offsets are zero;
/// - each boundary of the ghost (a closed chain of outer films around a raft or a hole) has at
///   least two films;
/// - Euler's relation holds: V - E + F = 0 on a torus; V - E + F + B = 2 R in the plane, for B
///   boundaries and R rafts.
std::optional<std::string> find_fault(const Network& network);

}  // namespace foam
