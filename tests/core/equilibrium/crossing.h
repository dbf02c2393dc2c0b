// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/foam/foam.h"

namespace foam::test {

/// A foam with one short film, well away from the seams.
struct Crossing {
    Foam foam;
    FilmId film;
    Vec2 middle;  // of the film
};

/// honeycomb(4, 4) in which the film between bubbles 5 and 6 is laid along x, with bubble 5 above,
/// and its four outer films leave the film's middle by the given angle (degrees) to either side of
/// the x axis, straight and 0.6 long but for half of the film. Every pressure is 0, every target 1.
/// For a film much shorter than that the pull of its outer films along it is 2 cos(angle), and
/// 2 sin(angle) along the flipped film.
Crossing crossing(double degrees, double length);

}  // namespace foam::test
