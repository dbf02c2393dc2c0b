// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/mesh/flat_region.h"
#include "texgen/vector/chain.h"

#include <cstddef>
#include <span>
#include <vector>

namespace foam::texgen {

/// Returns the number of equal parts into which an arc is divided. No point of the arc is farther
/// than `tolerance` millimeters from the chord of its part. Each part turns by at most half a
/// radian. Preconditions: the arc turns by less than 360 degrees; tolerance > 0.
std::size_t part_count(const DrawnArc& arc, double tolerance);

/// Returns closed chains as polygons whose corners are on the arcs. No point of an arc is farther
/// than `tolerance` millimeters from the polygon. Precondition: tolerance > 0.
std::vector<Ring> flattened(std::span<const Chain> chains, double tolerance);

}  // namespace foam::texgen
