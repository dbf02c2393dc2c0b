// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/vector/chain.h"

#include <span>
#include <vector>

namespace foam::texgen {

/// Returns the outlines of walls along lines, which are the arcs of a net. `width` is the full
/// width of the walls, in millimeters. The walls consist of all points that are at most half the
/// width from a line, so that they have round ends. All outlines are closed chains of circular arcs
/// with the walls on their left. If walls touch each other in a point, all walls may be wider by a
/// factor of up to 1 + 3e-6. Otherwise, the outlines are accurate to about 1e-8 of the length of a
/// line. The result is empty if there are no lines.
///
/// Precondition: width > 0, and lines meet only in their nodes. Takes time in proportion to n log n
/// for n lines if only a bounded number of lines is near each line. Throws std::invalid_argument if
/// rounding errors hide how an outline continues, which no known foam causes.
std::vector<Chain> wall_outlines(std::span<const NetArc> lines, double width);

}  // namespace foam::texgen
