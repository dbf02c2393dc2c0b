// SPDX-License-Identifier: Apache-2.0

#include "core/dynamics/collapse.h"
#include "core/foam/honeycomb.h"
#include "core/io/evolver_file.h"
#include "tests/core/foams.h"
#include "tests/core/io/small_torus.h"

#include <gtest/gtest.h>

#include <stdexcept>

namespace foam {
namespace {

TEST(EvolverWriter, WritesEveryNumberOfASmallFoam) {
    Foam foam = read_evolver(test::kSmallTorus, "a.fe").foam;
    foam.film_tension = 2.0;
    foam.pressures[BubbleId{0}] = 7.0;
    EXPECT_EQ(write_evolver(foam), R"(// A foam of 1 bubbles on a torus

STRING
SPACE_DIMENSION 2
LENGTH_METHOD_NAME "circular_arc_length"
AREA_METHOD_NAME "circular_arc_area"
QUADRATIC
TORUS_FILLED
PERIODS
3 0
0 2

vertices
1 0 0.5
2 1 1
3 0.5 0.75
4 2 1.75
5 2 0.75

edges
1 1 2 /*midpt*/ 3 * * tension 2
2 2 1 /*midpt*/ 4 + + tension 2
3 2 1 /*midpt*/ 5 + * tension 2

faces
1 1 2 -3 -1 -2 3

bodies
1 1 volume 6 lagrange_multiplier 0

read
)");
}

// Expects that b has all values of a that a data file contains. A data file does not contain the
// outgoing half-edges of junctions, the armed flags of films and the time. Pressures are shifted by
// a constant.
void expect_kept(const Foam& a, const Foam& b) {
    ASSERT_EQ(a.network.film_slots(), b.network.film_slots());
    for (std::size_t k = 0; k < 2 * a.network.film_slots(); ++k) {
        const auto h = id_at<HalfEdgeId>(k);
        EXPECT_EQ(a.network.tail(h), b.network.tail(h));
        EXPECT_EQ(a.network.left(h), b.network.left(h));
        EXPECT_EQ(a.network.next(h), b.network.next(h));
        EXPECT_EQ(chord(a, h), chord(b, h));
    }
    EXPECT_TRUE(a.positions == b.positions);
    EXPECT_TRUE(a.target_areas == b.target_areas);
    for (const BubbleId bubble : a.network.bubbles()) {
        EXPECT_EQ(a.pressures[bubble] - a.pressures[BubbleId{0}], b.pressures[bubble]);
    }
}

TEST(EvolverWriter, RoundTripsBitForBit) {
    for (const Foam& foam :
         {test::equilibrated_foam(60, 3), test::equilibrated_foam(2, 1), honeycomb(1, 2)}) {
        for (const EvolverEdges edges : {EvolverEdges::Arcs, EvolverEdges::Straight}) {
            expect_kept(foam, read_evolver(write_evolver(foam, edges), "a.fe").foam);
        }
    }
}

TEST(EvolverWriter, WritesLongWrapsAsNumbers) {
    Foam foam = read_evolver(test::kSmallTorus, "a.fe").foam;
    foam.network.rebase(JunctionId{1}, {-2, 3});
    foam.positions[JunctionId{1}] += foam.domain.translation({2, -3});
    const std::string text = write_evolver(foam);
    EXPECT_NE(text.find("1 1 2 /*midpt*/ 3 wrap 222\n"), std::string::npos) << text;  // (-2, 3)
    EXPECT_TRUE(test::are_same(read_evolver(text, "a.fe").foam,
                               read_evolver(test::kSmallTorus, "a.fe").foam));
}

TEST(EvolverWriter, RejectsWrapsThatTheFormatCannotStore) {
    const auto written = [](LatticeOffset offset) {
        Foam foam = read_evolver(test::kSmallTorus, "a.fe").foam;
        foam.network.set_offset(HalfEdgeId{0}, offset);
        return write_evolver(foam);
    };
    EXPECT_NE(written({-16, 15}).find("1 1 2 /*midpt*/ 3 wrap 976\n"), std::string::npos);
    EXPECT_THROW(written({16, 0}), std::range_error);
    try {
        written({0, -17});
        FAIL();
    } catch (const std::range_error& error) {
        EXPECT_STREQ(error.what(),
                     "edge 1 wraps -17 times around the torus; a Surface Evolver file can store "
                     "only -16 to 15");
    }
}

TEST(EvolverWriter, RejectsBubblesWithoutNeighbors) {
    Foam foam = read_evolver(test::kSmallTorus, "a.fe").foam;
    foam.lone_bubbles.push_back({9, {5.0, 5.0}, 3.0});
    try {
        write_evolver(foam);
        FAIL();
    } catch (const std::range_error& error) {
        EXPECT_STREQ(error.what(),
                     "a Surface Evolver file cannot store bubbles without neighbors, of which this "
                     "foam has 1; use a .json file");
    }
}

TEST(EvolverWriter, LeavesOutDeadSlots) {
    Foam foam = test::honeycomb_around(3);
    TopologyCounts counts;
    ASSERT_TRUE(collapse(foam, BubbleId{5}, counts));
    Foam dense = foam;
    compact(dense);
    expect_kept(dense, read_evolver(write_evolver(foam), "a.fe").foam);
}

}  // namespace
}  // namespace foam
