#pragma once

#include "core/network/network.h"

#include <optional>
#include <string>

namespace foam {

/// The first broken invariant in words, or nothing where the network is a foam on a torus:
/// every junction joins three live films; next, left, tail and the representatives agree; loops
/// close after `sides` half-edges (at least two) with no net lattice offset, so that every bubble
/// is a disc; no film has one copy of a bubble on both sides; counts agree and satisfy Euler's
/// relation V - E + F = 0.
std::optional<std::string> find_fault(const Network& network);

}  // namespace foam
