// SPDX-License-Identifier: Apache-2.0

#include "core/reference/junction_block.h"

#include "core/foam/honeycomb.h"
#include "core/foam/measure.h"
#include "core/geometry/bulge_energy.h"
#include "tests/core/equilibrium/derivative_foams.h"
#include "tests/core/foams.h"
#include "tests/core/patches.h"
#include "tests/support/sample_foams.h"

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

// Returns the errors of the block's constraints, computed by other functions: 1 - A / A_target of
// its bubbles (core/foam/measure.h), minus the error of Laplace-Young's law of its outer films
// (core/geometry/bulge_energy.h), and 120 degrees minus the angles between the tangents of the
// arcs. The angle on the left of a film is the counter-clockwise turn to the next film, which
// precedes it in the clockwise order of leaving().
BlockVector measured(const Foam& foam, JunctionId junction, const JunctionBlock& block) {
    BlockVector lacking(block.size());
    const auto bubbles = block.bubbles();
    for (std::size_t k = 0; k < bubbles.size(); ++k) {
        lacking[static_cast<Index>(k)] =
            1.0 - bubble_area(foam, bubbles[k]) / foam.target_areas[bubbles[k]];
    }
    const auto outer_films = block.outer_films();
    for (std::size_t k = 0; k < outer_films.size(); ++k) {
        const HalfEdgeId h = forward_side(outer_films[k]);
        lacking[static_cast<Index>(bubbles.size() + k)] = -laplace_young_error(
            film_arc(foam, h), pressure_difference(foam, h), foam.film_tension);
    }
    const std::array<HalfEdgeId, 3> leaving = foam.network.leaving(junction);
    for (std::size_t k = 0; k < 2; ++k) {
        const Vec2 a = tangent_at_tail(film_arc(foam, leaving[k]));
        const Vec2 b = tangent_at_tail(film_arc(foam, leaving[(k + 2) % 3]));
        const double lack = 2.0 * kPi / 3.0 - std::atan2(cross(a, b), a.dot(b));
        lacking[block.size() - 2 + static_cast<Index>(k)] = std::remainder(lack, 2.0 * kPi);
    }
    return lacking;
}

// Returns the foam after a change of the block's unknowns.
Foam after(Foam foam, JunctionId junction, const JunctionBlock& block, const BlockVector& change) {
    foam.positions[junction] += block.move(change);
    for (std::size_t k = 0; k < block.bubbles().size(); ++k) {
        foam.pressures[block.bubbles()[k]] += block.pressure_change(change, k);
    }
    for (std::size_t k = 0; k < block.outer_films().size(); ++k) {
        foam.half_angles[block.outer_films()[k]] += block.half_angle_change(change, k);
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

// At the surface, a block has two pressures (paper eq. 15). The half angles of the outer films of
// its bubbles are added.
TEST(JunctionBlock, LeavesTheGhostOut) {
    const Foam foam = test::flower(1.0);
    JunctionBlock block;
    for (const JunctionId junction : foam.network.junctions()) {
        block.load(foam, junction);
        int ghosts = 0;
        for (const HalfEdgeId h : foam.network.leaving(junction)) {
            ghosts += foam.network.left(h) == foam.network.ghost() ? 1 : 0;
        }
        EXPECT_EQ(static_cast<int>(block.bubbles().size()), 3 - ghosts);
        EXPECT_EQ(block.outer_films().size(), 2U);  // one for each petal at the junction
        EXPECT_EQ(block.size(), 7 - ghosts);
    }
}

TEST(JunctionBlock, HasNoErrorsInAHoneycomb) {
    const Foam foam = honeycomb(4, 4);
    JunctionBlock block;
    for (const JunctionId junction : foam.network.junctions()) {
        block.load(foam, junction);
        EXPECT_LT(block.constraint_errors(BlockVector::Zero(5)).norm(), 1e-13);
    }
}

// Compares the errors of the block with errors that are measured in the foam, before and after a
// change of each unknown. Some foams have films at the limit of their half angle, or bubbles that
// are their own neighbors.
void expect_measured_errors(const std::vector<Foam>& foams) {
    JunctionBlock block;
    for (const Foam& foam : foams) {
        for (const JunctionId junction : foam.network.junctions()) {
            block.load(foam, junction);
            BlockVector change = BlockVector::Zero(block.size());
            EXPECT_LT((block.constraint_errors(change) - measured(foam, junction, block)).norm(),
                      1e-12);
            for (Index unknown = 0; unknown < block.size(); ++unknown) {
                change[unknown] = 0.1 + 0.03 * static_cast<double>(unknown);
                const Foam changed = after(foam, junction, block, change);
                EXPECT_LT(
                    (block.constraint_errors(change) - measured(changed, junction, block)).norm(),
                    1e-12);
            }
        }
    }
}

TEST(JunctionBlock, ErrorsAgreeWithMeasuredOnes) {
    expect_measured_errors(derivative_foams());
}

// The half angles of outer films are below and above 90 degrees.
TEST(JunctionBlock, ErrorsAgreeWithMeasuredOnesInAPatch) {
    expect_measured_errors(test::derivative_patches());
}

TEST(JunctionBlock, DoesNotDependOnThePreviousJunction) {
    const Foam foam = test::bent_foam(12, 0.5, 1);
    JunctionBlock used;
    used.load(foam, JunctionId{5});
    used.load(foam, JunctionId{2});
    JunctionBlock fresh;
    fresh.load(foam, JunctionId{2});
    EXPECT_EQ(used.constraint_errors(BlockVector::Zero(5)),
              fresh.constraint_errors(BlockVector::Zero(5)));
}

// The unit of a pressure is the film tension divided by the square root of the target area, here
// 2 / sqrt(4). The unit of a coordinate is the length of the shortest film, here 0.1.
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
