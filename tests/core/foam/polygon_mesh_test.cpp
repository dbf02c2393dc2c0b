// SPDX-License-Identifier: Apache-2.0

#include "core/foam/polygon_mesh.h"

#include "core/foam/measure.h"
#include "core/network/t1.h"
#include "tests/core/foams.h"
#include "tests/core/patches.h"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

namespace foam {
namespace {

using test::is_valid;

TEST(PolygonMesh, MakesValidPatches) {
    for (const Foam& foam : {test::double_bubble(1.0, 1.0),
                             test::triple_bubble(1.0),
                             test::flower(1.0),
                             test::chain(),
                             test::ring()}) {
        EXPECT_TRUE(is_valid(foam.network));
        EXPECT_TRUE(foam.domain.is_plane());
        EXPECT_EQ(foam.half_angles.size(), foam.network.film_slots());
        EXPECT_EQ(foam.pressures[foam.network.ghost()], 0.0);
        EXPECT_TRUE(std::isinf(foam.target_areas[foam.network.ghost()]));
    }
}

// A flower has seven bubbles, twelve junctions, and eighteen films, of which six are outer films.
TEST(PolygonMesh, CountsAFlower) {
    const Network network = test::flower(1.0).network;
    EXPECT_EQ(network.bubble_count(), 7U);
    EXPECT_EQ(network.film_count(), 18U);
    EXPECT_EQ(network.junction_count(), 12U);
    EXPECT_EQ(network.sides(BubbleId{0}), 6);
    EXPECT_EQ(network.sides(BubbleId{1}), 4);
    EXPECT_EQ(network.sides(network.ghost()), 6);
}

// The half-edges of the ghost run clockwise around the patch, so that their polygon has a negative
// area.
TEST(PolygonMesh, LinksTheGhostFromFilmToFilm) {
    const Foam foam = test::flower(1.0);
    const HalfEdgeId first = foam.network.first(foam.network.ghost());
    double twice = 0.0;
    HalfEdgeId h = first;
    do {
        EXPECT_EQ(foam.network.left(h), foam.network.ghost());
        twice += cross(foam.positions[foam.network.tail(h)], foam.positions[foam.network.head(h)]);
        h = foam.network.next(h);
    } while (h != first);
    EXPECT_NEAR(0.5 * twice, -1.5 * std::sqrt(3.0) * 1.6 * 1.6, 1e-12);
}

TEST(PolygonMesh, DissolvesPointsOfTwoSides) {
    const Foam foam = test::double_bubble(1.0, 1.0);
    EXPECT_EQ(foam.network.junction_count(), 2U);
    EXPECT_EQ(foam.network.film_count(), 3U);
    EXPECT_EQ(foam.network.sides(foam.network.ghost()), 2);
}

TEST(PolygonMesh, RejectsInvalidFoams) {
    const std::vector<Vec2> points{
        {0.0, 0.0}, {1.0, 0.0}, {0.0, 1.0}, {-1.0, 0.0}, {0.0, -1.0}, {1.0, 1.0}};
    // A corner joins four cells.
    EXPECT_THROW(foam_from_mesh({points, {{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {0, 4, 1}}}),
                 std::runtime_error);
    // A single cell has no corner that joins three sides. The same cell twice has two sides in the
    // same direction.
    EXPECT_THROW(foam_from_mesh({points, {{0, 1, 2}}}), std::runtime_error);
    EXPECT_THROW(foam_from_mesh({points, {{0, 1, 2}, {0, 1, 2}}}), std::runtime_error);
}

// A T1 at the outer film of a petal (patches.h): the petal loses contact with the ghost, and its
// two neighbors touch.
TEST(PolygonMesh, FlipsAnOuterFilm) {
    Network network = test::flower(1.0).network;
    const FilmId outer = film_of(test::side_between(network, BubbleId{1}, network.ghost()));
    ASSERT_TRUE(can_flip(network, outer));
    flip(network, outer);
    EXPECT_TRUE(is_valid(network));
    EXPECT_FALSE(network.is_outer(outer));
    EXPECT_EQ(network.sides(BubbleId{1}), 3);
    EXPECT_EQ(network.sides(network.ghost()), 5);
}

// A T1 at the film between two petals: the middle bubble comes into contact with the ghost.
TEST(PolygonMesh, FlipsAFilmThatEndsAtTheGhost) {
    Network network = test::flower(1.0).network;
    const FilmId film = film_of(test::side_between(network, BubbleId{1}, BubbleId{2}));
    ASSERT_TRUE(can_flip(network, film));
    flip(network, film);
    EXPECT_TRUE(is_valid(network));
    EXPECT_TRUE(network.is_outer(film));
    EXPECT_EQ(network.sides(BubbleId{0}), 7);
    EXPECT_EQ(network.sides(network.ghost()), 7);
}

// A flip would leave the ghost a boundary of only one film.
TEST(PolygonMesh, KeepsTwoFilmsOnEachBoundary) {
    const Network network = test::double_bubble(1.0, 1.0).network;
    for (const FilmId film : network.films()) {
        EXPECT_FALSE(can_flip(network, film));
    }
}

TEST(PolygonMesh, CompactsWithTheGhostLast) {
    Foam foam = test::chain();
    foam.network.remove(BubbleId{0});  // leaves no valid foam; only ids are tested
    compact(foam);
    EXPECT_EQ(foam.network.ghost(), BubbleId{3});
    EXPECT_TRUE(std::isinf(foam.target_areas[BubbleId{3}]));
}

}  // namespace
}  // namespace foam
