// SPDX-License-Identifier: Apache-2.0

#include "core/equilibrium/untangle.h"

#include "core/equilibrium/equilibrate.h"
#include "core/foam/honeycomb.h"
#include "core/foam/measure.h"
#include "tests/core/foams.h"
#include "tests/support/sample_foams.h"

#include <gtest/gtest.h>

#include <vector>

namespace foam {
namespace {

using test::are_same;
using test::equilibrated_foam;
using test::is_valid;

int count_tangled(const Foam& foam) {
    int tangled = 0;
    for (const JunctionId junction : foam.network.junctions()) {
        tangled += is_tangled(foam, junction) ? 1 : 0;
    }
    return tangled;
}

void expect_positive_areas(const Foam& foam) {
    for (const BubbleId bubble : foam.network.bubbles()) {
        EXPECT_GT(polygon_area(foam, bubble), 0.0) << index_of(bubble);
    }
}

// Scales a bubble around its first junction by the factors x and y.
void scale_bubble(Foam& foam, BubbleId bubble, double x, double y) {
    std::vector<Vec2> points;
    Vec2 at = Vec2::Zero();
    for (const HalfEdgeId h : foam.network.around(bubble)) {
        points.push_back(at);
        at += chord(foam, h);
    }
    std::size_t k = 0;
    for (const HalfEdgeId h : foam.network.around(bubble)) {
        const JunctionId junction = foam.network.tail(h);
        const Vec2& from_first = points[k++];
        const Vec2 move((x - 1.0) * from_first.x(), (y - 1.0) * from_first.y());
        place_junction(foam, junction, foam.positions[junction] + move);
    }
}

void mirror(Foam& foam, BubbleId bubble) {
    scale_bubble(foam, bubble, -1.0, 1.0);
}

void shrink_to_a_point(Foam& foam, BubbleId bubble) {
    scale_bubble(foam, bubble, 0.0, 0.0);
}

TEST(Untangle, KeepsAFoamWithoutTangles) {
    Foam foam = equilibrated_foam(100, 1);
    const Foam before = foam;
    EXPECT_EQ(count_tangled(foam), 0);
    EXPECT_EQ(untangle(foam), 0);
    EXPECT_TRUE(are_same(foam, before));
}

// The chords of the two films of a two-sided bubble have the same direction, but its junctions are
// not tangled.
TEST(Untangle, DoesNotCountATwoSidedBubbleAsATangle) {
    Foam foam = honeycomb(4, 4);
    test::insert_lens(foam, FilmId{7}, 0.5);
    EXPECT_EQ(untangle(foam), 0);
}

TEST(Untangle, RestoresAnInvertedBubble) {
    Foam foam = equilibrated_foam(100, 1);
    mirror(foam, BubbleId{3});
    ASSERT_LT(polygon_area(foam, BubbleId{3}), 0.0);
    ASSERT_GT(count_tangled(foam), 0);
    EXPECT_GT(untangle(foam), 0);
    EXPECT_EQ(count_tangled(foam), 0);
    EXPECT_TRUE(is_valid(foam.network));
    expect_positive_areas(foam);
}

TEST(Untangle, OpensABubbleThatIsAPoint) {
    Foam foam = honeycomb(4, 4);
    shrink_to_a_point(foam, BubbleId{5});
    EXPECT_EQ(count_tangled(foam), 6);
    EXPECT_EQ(untangle(foam), 6);
    EXPECT_EQ(count_tangled(foam), 0);
    expect_positive_areas(foam);
}

// A junction that is more than two films away from the junctions of the bubble does not move.
TEST(Untangle, MovesOnlyNearbyJunctions) {
    Foam foam = honeycomb(8, 8);
    shrink_to_a_point(foam, BubbleId{27});
    const Foam before = foam;
    EXPECT_EQ(untangle(foam), 6);
    int moved = 0;
    for (const JunctionId junction : foam.network.junctions()) {
        moved += foam.positions[junction] == before.positions[junction] ? 0 : 1;
    }
    EXPECT_GT(moved, 6);
    // The bubble has 6 junctions. Next to them are 6 more, each with two further neighbors:
    // 6 + 6 + 12 = 24.
    EXPECT_LE(moved, 24);
}

// Without untangling, relaxation and the T1s of Newton's method would not bring all of these foams
// to equilibrium.
TEST(Equilibrate, RecoversFromTangles) {
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
        Foam foam = equilibrated_foam(60, seed);
        for (std::size_t k = 0; k < 56; k += 8) {
            mirror(foam, id_at<BubbleId>(k));
            shrink_to_a_point(foam, id_at<BubbleId>(k + 4));
        }
        EXPECT_TRUE(equilibrate(foam, {.relaxes_first = seed % 2 == 0}).converged()) << seed;
        EXPECT_TRUE(is_valid(foam.network));
        EXPECT_EQ(count_tangled(foam), 0);
    }
}

}  // namespace
}  // namespace foam
