// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/foam/foam.h"
#include "core/foam/frame.h"

#include <cstdint>
#include <string>
#include <vector>

namespace foam::test {

/// The frame of a foam whose torus and junctions are stretched to the aspect of an image, so that
/// pixels are square; the arcs are made anew, from the pressures.
Frame fitted_frame(Foam foam, int width, int height);

/// A Voronoi diagram whose films are bent by random pressures up to `pressure` (of either sign):
/// angles far from 120 degrees.
Foam bent_foam(int bubbles, double pressure, std::uint64_t seed);

/// A foam in equilibrium, with very different areas.
Foam polydisperse_foam(int bubbles, std::uint64_t seed);

/// A patch in equilibrium, seeded in an outline given as WKT, or in a disc.
Foam patch_foam(int bubbles, std::uint64_t seed, const std::string& wkt = {});

/// Six bubbles around a hole: between two hexagons around the origin, of radius 1 and 2.2, whose
/// sides bulge outwards from the bubbles by half angles of 0.3 and 0.7. Not in equilibrium.
Foam ring_foam();

/// A patch without any bubble in touch with another.
Foam circles(const std::vector<LoneBubble>& bubbles);

/// One bubble that meets itself around the unit torus in all its six sides.
Foam single_bubble();

/// Puts a two-sided bubble in the middle of a straight film: a part of its chord, its films at 120
/// degrees. Returns the bubble.
BubbleId insert_lens(Foam& foam, FilmId film, double part_of_chord);

}  // namespace foam::test
