// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/network/network.h"

#include <optional>
#include <string>

namespace foam {

/// Returns a description of the first broken invariant, or nothing if the network is valid:
/// - every junction joins three live films;
/// - next, left, tail, first and outgoing half-edges are consistent;
/// - the loop around a bubble closes after `sides` half-edges, at least two, with no net lattice
///   offset, so that every bubble is a disc;
/// - no film has the same copy of a bubble on both sides;
/// - counts are consistent and satisfy Euler's relation: on a torus V - E + F = 0;
/// - in the plane, all lattice offsets are zero, and each boundary of the ghost has at least two
///   films; if each boundary counts as a face, V - E + F is twice the number of rafts.
std::optional<std::string> find_fault(const Network& network);

}  // namespace foam
