// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/foam/foam.h"

#include <gtest/gtest.h>

#include <cstdint>

namespace foam::test {

/// Returns success if the network satisfies every invariant, otherwise a failure that names the
/// first broken one (find_fault in validate.h).
::testing::AssertionResult is_valid(const Network& network);

/// Returns success if two networks agree in every element, including dead slots, otherwise a
/// failure that names the first difference.
::testing::AssertionResult are_same(const Network& a, const Network& b);

/// Returns success if two foams agree to the last bit, otherwise a failure that names the
/// difference. Events are not compared.
::testing::AssertionResult are_same(const Foam& a, const Foam& b);

/// Returns the Voronoi diagram of random sites, which is far from equilibrium.
Foam raw_foam(int bubbles, std::uint64_t seed);

/// Returns raw_foam(bubbles, seed), brought to equilibrium.
Foam equilibrated_foam(int bubbles, std::uint64_t seed);

/// Returns the side of a bubble across which the neighbor is, or the first such side if there are
/// several. Precondition: the bubbles are neighbors.
HalfEdgeId side_between(const Network& network, BubbleId bubble, BubbleId neighbor);

/// Returns the sum of the target areas of the live bubbles, without lone bubbles.
double total_target(const Foam& foam);

/// Returns honeycomb(4, 4) after T1s that take sides from bubble 5, one after another, until it has
/// the given number of sides, 2 to 6. The neighbors of bubble 5 are 6, 10, 9, 4, 1 and 2,
/// counter-clockwise from its right. It first loses its films with 10, 4 and 2, so that it has
/// three sides, and then its film with 6.
Foam honeycomb_around(int sides);

}  // namespace foam::test
