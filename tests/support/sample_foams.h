// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/foam/foam.h"
#include "core/foam/frame.h"

#include <cstdint>
#include <string>
#include <vector>

namespace foam::test {

/// Returns a frame of the foam after its torus and its junctions were stretched vertically to the
/// aspect ratio of an image of `width` x `height` pixels, so that its pixels are square on the
/// torus. The arcs are recomputed from the pressures.
Frame fitted_frame(Foam foam, int width, int height);

/// Returns a Voronoi diagram whose films are bent by random pressures from -`pressure` to
/// `pressure`. The angles at its junctions are far from 120 degrees.
Foam bent_foam(int bubbles, double pressure, std::uint64_t seed);

/// Returns a foam in equilibrium whose target areas differ by a factor of up to 30.
Foam polydisperse_foam(int bubbles, std::uint64_t seed);

/// Returns a patch in equilibrium, seeded in an outline given as WKT. An empty text means a disc.
Foam patch_foam(int bubbles, std::uint64_t seed, const std::string& wkt = {});

/// Returns six bubbles around a hole, not in equilibrium. The bubbles are between two hexagons
/// around the origin with circumscribed radii of 1 and 2.2. The outer films bulge outwards from the
/// bubbles. Their half angles are 0.3 on the inner hexagon and 0.7 on the outer hexagon.
Foam ring_foam();

/// Returns a patch in which no bubble touches another.
Foam circles(const std::vector<LoneBubble>& bubbles);

/// Returns a foam of one bubble on the unit torus, which is its own neighbor on all six sides.
Foam single_bubble();

/// Inserts a two-sided bubble in the middle of a straight film and returns it. The bubble covers
/// the fraction `part_of_chord` of the film. The three films at each of its junctions meet at 120
/// degrees.
BubbleId insert_lens(Foam& foam, FilmId film, double part_of_chord);

}  // namespace foam::test
