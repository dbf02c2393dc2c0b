#pragma once

#include "core/foam/foam.h"

namespace foam {

/// Whether the film parts the two bubbles of a raft of two.
bool is_inside_double_bubble(const Network& network, FilmId film);

/// Brings a raft of two to equilibrium in closed form, with its middle and the direction of its
/// chord kept. All three films stand on one chord. With half angle beta of the film between, which
/// bulges into the larger bubble, 120 degrees at the ends ask for outer half angles of 120 degrees
/// - beta and + beta; the ratio of the areas tells beta (E1: h is ArcShape::segment):
///     4 A_small / c² = h(120 - beta) + h(beta),   4 A_large / c² = h(120 + beta) - h(beta).
void settle_double_bubble(Foam& foam, FilmId film);

}  // namespace foam
