#pragma once

#include "core/network/network.h"

#include <optional>
#include <string>

namespace foam {

/// The first broken invariant in words, or nothing where the network is a foam:
/// every junction joins three live films; next, left, tail and the representatives agree; loops
/// close after `sides` half-edges (at least two) with no net lattice offset, so that every bubble
/// is a disc; no film has one copy of a bubble on both sides; counts agree and satisfy Euler's
/// relation, on a torus V - E + F = 0. In the plane all lattice offsets are zero, each boundary of
/// the ghost has two films at least, and with each of them as a face V - E + F = 2 for every raft.
std::optional<std::string> find_fault(const Network& network);

}  // namespace foam
