// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/foam/foam.h"

namespace foam::test {

/// A foam with one short film, far from the border of the torus' cell.
struct Crossing {
    Foam foam;
    FilmId film;
    Vec2 middle;  // of the film
};

/// Returns honeycomb(4, 4) with a short film of the given length between bubbles 5 and 6. The film
/// is parallel to the x axis, with bubble 5 above it. Each of the four adjacent films ends at a
/// distance of 0.6 from the middle of the short film, in a direction that makes the given angle
/// (degrees) with the x axis. All films are straight: every pressure is 0. Every target area is 1.
/// If the film is much shorter than 0.6, the two adjacent films at each end pull with 2 cos(angle)
/// film tensions along the film, and with 2 sin(angle) along the flipped film.
Crossing crossing(double degrees, double length);

}  // namespace foam::test
