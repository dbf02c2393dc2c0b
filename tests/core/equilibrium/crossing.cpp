// SPDX-License-Identifier: Apache-2.0

#include "tests/core/equilibrium/crossing.h"

#include "core/foam/honeycomb.h"
#include "core/network/t1.h"
#include "tests/core/foams.h"

#include <cmath>
#include <numbers>

namespace foam::test {

Crossing crossing(double degrees, double length) {
    Foam foam = honeycomb(4, 4);
    const HalfEdgeId side = side_between(foam.network, BubbleId{5}, BubbleId{6});
    const FilmId film = film_of(side);
    const T1Site site = t1_site(foam.network, film);  // site.film is `side`: upward, 5 on its left
    const Vec2 middle = foam.positions[foam.network.tail(side)] + 0.5 * chord(foam, side);
    const double angle = degrees * std::numbers::pi / 180.0;
    const Vec2 up(0.6 * std::cos(angle), 0.6 * std::sin(angle));
    const Vec2 down(up.x(), -up.y());
    const Network& network = foam.network;
    place_junction(foam, network.tail(side), middle - Vec2(0.5 * length, 0.0));
    place_junction(foam, network.head(side), middle + Vec2(0.5 * length, 0.0));
    place_junction(foam, network.head(site.after_left), middle + up);
    place_junction(foam, network.tail(site.before_right), middle + down);
    place_junction(foam, network.tail(site.before_left), middle - down);
    place_junction(foam, network.head(site.after_right), middle - up);
    return {foam, film, middle};
}

}  // namespace foam::test
