// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/foam/foam.h"

#include <cstddef>

namespace foam {

/// Foams with at least this many bubbles are sorted after seeding (sort_if_large). Sorted foams of
/// 20,000 and of 100,000 bubbles reach equilibrium sooner; foams of 10,000 and of 30,000 bubbles do
/// not gain (core/equilibrium/NOTES.md). Other sizes between 10,000 and 100,000 were not measured.
inline constexpr std::size_t kMinSortedBubbles = 20'000;

/// Renumbers the junctions, films and bubbles of a foam along a Hilbert curve. Elements that are
/// close together in the foam are then mostly close together in memory, so that the solver reads
/// large foams faster. The identities of bubbles do not change, and the ghost remains the last
/// bubble. Removes dead slots (compact).
void sort_along_curve(Foam& foam);

/// Sorts a foam along the curve if it has at least kMinSortedBubbles bubbles.
void sort_if_large(Foam& foam);

}  // namespace foam
