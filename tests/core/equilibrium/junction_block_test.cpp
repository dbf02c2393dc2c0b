#include "core/equilibrium/junction_block.h"

#include "core/foam/honeycomb.h"
#include "core/foam/measure.h"
#include "tests/core/equilibrium/derivative_foams.h"
#include "tests/core/foams.h"
#include "tests/support/raster_frames.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>
#include <set>

namespace foam {
namespace {

using Eigen::Index;
using test::derivative_foams;

constexpr double kPi = std::numbers::pi;

// 1 - A / A_target of the block's bubbles and 120 degrees less the angles, from core/foam/measure.h
// and from the tangents of the arcs: the angle on the left of a film is the turn,
// counter-clockwise, to the film after it, which is the one before it in the clockwise order of
// leaving().
BlockVector measured(const Foam& foam, JunctionId junction, const JunctionBlock& block) {
    BlockVector lacking(block.size());
    const auto bubbles = block.bubbles();
    for (std::size_t k = 0; k < bubbles.size(); ++k) {
        lacking[static_cast<Index>(k)] =
            1.0 - bubble_area(foam, bubbles[k]) / foam.target_areas[bubbles[k]];
    }
    const std::array<HalfEdgeId, 3> leaving = foam.network.leaving(junction);
    for (std::size_t k = 0; k < 2; ++k) {
        const Vec2 a = tangent_at_tail(film_arc(foam, leaving[k]));
        const Vec2 b = tangent_at_tail(film_arc(foam, leaving[(k + 2) % 3]));
        const double lack = 2.0 * kPi / 3.0 - std::atan2(cross(a, b), a.dot(b));
        lacking[static_cast<Index>(bubbles.size() + k)] = lack > kPi ? lack - 2.0 * kPi : lack;
    }
    return lacking;
}

Foam after(Foam foam, JunctionId junction, const JunctionBlock& block, const BlockVector& change) {
    foam.positions[junction] += block.move(change);
    for (std::size_t k = 0; k < block.bubbles().size(); ++k) {
        foam.pressures[block.bubbles()[k]] += block.pressure_change(change, k);
    }
    return foam;
}

TEST(JunctionBlock, HasOnePressureForEachBubbleOfTheJunction) {
    JunctionBlock block;
    const Foam ordinary = honeycomb(4, 4);
    block.load(ordinary, JunctionId{3});
    EXPECT_EQ(block.size(), 5);
    const std::set<BubbleId> bubbles(block.bubbles().begin(), block.bubbles().end());
    EXPECT_EQ(bubbles.size(), 3U);
    for (const HalfEdgeId h : ordinary.network.leaving(JunctionId{3})) {
        EXPECT_EQ(bubbles.count(ordinary.network.left(h)), 1U);
    }
    block.load(honeycomb(1, 2), JunctionId{0});
    EXPECT_EQ(block.size(), 4);
    block.load(test::single_bubble(), JunctionId{0});
    EXPECT_EQ(block.size(), 3);
}

TEST(JunctionBlock, LacksNothingInTheHoneycomb) {
    const Foam foam = honeycomb(4, 4);
    JunctionBlock block;
    for (const JunctionId junction : foam.network.junctions()) {
        block.load(foam, junction);
        EXPECT_LT(block.lacking(BlockVector::Zero(5)).norm(), 1e-13);
    }
}

// By its own bookkeeping the block says what measuring says, before and after a change of each of
// its unknowns; also where films are held at the limit and where bubbles meet themselves.
TEST(JunctionBlock, LacksWhatMeasuringSays) {
    JunctionBlock block;
    for (const Foam& foam : derivative_foams()) {
        for (const JunctionId junction : foam.network.junctions()) {
            block.load(foam, junction);
            BlockVector change = BlockVector::Zero(block.size());
            EXPECT_LT((block.lacking(change) - measured(foam, junction, block)).norm(), 1e-12);
            for (Index unknown = 0; unknown < block.size(); ++unknown) {
                change[unknown] = 0.1 + 0.03 * static_cast<double>(unknown);
                const Foam changed = after(foam, junction, block, change);
                EXPECT_LT((block.lacking(change) - measured(changed, junction, block)).norm(),
                          1e-12);
            }
        }
    }
}

TEST(JunctionBlock, ForgetsTheJunctionBefore) {
    const Foam foam = test::bent_foam(12, 0.5, 1);
    JunctionBlock used;
    used.load(foam, JunctionId{5});
    used.load(foam, JunctionId{2});
    JunctionBlock fresh;
    fresh.load(foam, JunctionId{2});
    EXPECT_EQ(used.lacking(BlockVector::Zero(5)), fresh.lacking(BlockVector::Zero(5)));
}

// A pressure is in tensions over the root of the target, a coordinate in lengths of the shortest
// film: here 2 / sqrt(4) and 0.1, by hand.
TEST(JunctionBlock, CountsInUnitsOfItsBubblesAndFilms) {
    Foam foam = honeycomb(4, 4);
    foam.film_tension = 2.0;
    for (double& area : foam.target_areas) {
        area = 4.0;
    }
    const HalfEdgeId h = foam.network.outgoing(JunctionId{3});
    foam.positions[JunctionId{3}] += (1.0 - 0.1 / chord(foam, h).norm()) * chord(foam, h);
    JunctionBlock block;
    block.load(foam, JunctionId{3});
    const BlockVector change = BlockVector::Ones(5);
    EXPECT_NEAR(block.pressure_change(change, 1), 1.0, 1e-15);
    EXPECT_LT((block.move(change) - Vec2(0.1, 0.1)).norm(), 1e-15);
}

TEST(JunctionBlock, IsDegenerateWhereAFilmHasNoLength) {
    Foam foam = honeycomb(4, 4);
    JunctionBlock block;
    block.load(foam, JunctionId{3});
    EXPECT_FALSE(block.is_degenerate());
    const HalfEdgeId h = foam.network.outgoing(JunctionId{3});
    foam.positions[JunctionId{3}] += chord(foam, h);
    ASSERT_TRUE(chord(foam, h) == Vec2(0.0, 0.0));
    block.load(foam, JunctionId{3});
    EXPECT_TRUE(block.is_degenerate());
}

}  // namespace
}  // namespace foam
