// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/foam/foam.h"

#include <gtest/gtest.h>

#include <cstdint>

namespace foam::test {

/// Whether the network keeps every invariant (validate.h); tells which one is broken.
::testing::AssertionResult is_valid(const Network& network);

/// Whether two networks agree in every element, dead slots included; tells where they do not.
::testing::AssertionResult are_same(const Network& a, const Network& b);

/// Whether two foams agree to the last bit; tells where they do not.
::testing::AssertionResult are_same(const Foam& a, const Foam& b);

/// The Voronoi diagram of random sites: far from equilibrium.
Foam raw_foam(int bubbles, std::uint64_t seed);

/// The same foam brought to equilibrium.
Foam equilibrated_foam(int bubbles, std::uint64_t seed);

/// The side of a bubble across which a neighbor lies: the first one, if there are several.
/// Precondition: the bubbles are neighbors.
HalfEdgeId side_between(const Network& network, BubbleId bubble, BubbleId neighbor);

/// Sum of the target areas of the live bubbles.
double total_target(const Foam& foam);

/// honeycomb(4, 4) whose bubble 5 has lost films by T1, one after the other, until it has so many
/// sides, 2 ... 6. Of its neighbors 6, 10, 9, 4, 1 and 2 (counter-clockwise from its right) first
/// every other one goes, 10, 4 and 2, which leaves a triangle, and then 6.
Foam honeycomb_around(int sides);

}  // namespace foam::test
