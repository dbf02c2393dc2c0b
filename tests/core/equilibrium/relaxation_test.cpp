// SPDX-License-Identifier: Apache-2.0

#include "core/equilibrium/relaxation.h"

#include "core/equilibrium/residual.h"
#include "core/foam/honeycomb.h"
#include "core/foam/measure.h"
#include "core/foam/seeding.h"
#include "tests/core/foams.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace foam {
namespace {

using test::is_valid;
using test::raw_foam;

ResidualNorms norms_of(const Foam& foam) {
    const Unknowns unknowns = all_unknowns(foam.network);
    return norms(foam, unknowns, residual(foam, unknowns));
}

// The diagrams start with forces near T and a sum of squares of 60 to 80. Relaxation leaves about a
// hundredth of this sum, because the pressures that bend the films are only estimates.
TEST(Relaxation, LeavesAHundredthOfTheResidual) {
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
        Foam foam = raw_foam(100, seed);
        const ResidualNorms before = norms_of(foam);
        relax(foam, {});
        const ResidualNorms after = norms_of(foam);
        EXPECT_TRUE(is_valid(foam.network));
        EXPECT_LT(after.squares, 0.02 * before.squares) << "seed " << seed;
        EXPECT_LT(after.force, 0.5 * before.force) << "seed " << seed;
        EXPECT_EQ(equilibrium_errors(foam).films_at_limit, 0);
    }
}

TEST(Relaxation, MoreSweepsDoMore) {
    for (std::uint64_t seed = 1; seed <= 5; ++seed) {
        Foam little = raw_foam(100, seed);
        Foam much = little;
        EXPECT_EQ(relax(little, {.sweeps = 5}).sweeps, 5);
        EXPECT_EQ(relax(much, {.sweeps = 50}).sweeps, 50);
        EXPECT_LT(norms_of(much).squares, norms_of(little).squares);
    }
}

double mean_pressure(const Foam& foam, const std::vector<BubbleId>& bubbles) {
    double sum = 0.0;
    for (const BubbleId bubble : bubbles) {
        sum += foam.pressures[bubble];
    }
    return sum / static_cast<double>(bubbles.size());
}

TEST(Relaxation, OfAPartChangesNothingElse) {
    Foam foam = test::equilibrated_foam(100, 4);
    const BubbleId middle = id_at<BubbleId>(50);
    std::vector<BubbleId> bubbles{middle};
    for (const HalfEdgeId h : foam.network.around(middle)) {
        bubbles.push_back(foam.network.right(h));
    }
    std::sort(bubbles.begin(), bubbles.end());
    const Unknowns part = unknowns_around(foam.network, bubbles);
    for (const HalfEdgeId h : foam.network.around(middle)) {
        foam.positions[foam.network.tail(h)] += 0.2 * chord(foam, h);
    }
    const Foam before = foam;
    const double pressure = mean_pressure(foam, bubbles);
    relax(foam, part, {});
    EXPECT_LT(norms_of(foam).squares, 0.3 * norms_of(before).squares);
    EXPECT_NEAR(mean_pressure(foam, bubbles), pressure, 0.2);
    for (const JunctionId junction : foam.network.junctions()) {
        EXPECT_TRUE(part.junction_rank[junction] >= 0 ||
                    foam.positions[junction] == before.positions[junction]);
    }
    for (const BubbleId bubble : foam.network.bubbles()) {
        EXPECT_TRUE(part.bubble_rank[bubble] >= 0 ||
                    foam.pressures[bubble] == before.pressures[bubble]);
    }
}

TEST(Relaxation, KeepsAHoneycomb) {
    Foam foam = honeycomb(4, 4);
    const Foam before = foam;
    const RelaxationSummary summary = relax(foam, {});
    EXPECT_EQ(summary.t1, 0);
    for (const FilmId film : foam.network.films()) {
        const HalfEdgeId h = forward_side(film);
        EXPECT_LT((chord(foam, h) - chord(before, h)).norm(), 1e-13);
    }
    for (const double pressure : foam.pressures) {
        EXPECT_NEAR(pressure, *foam.pressures.begin(), 1e-12);
    }
}

// A junction may leave the torus' own cell during the sweeps. It is wrapped at the end of the
// relaxation.
TEST(Relaxation, LeavesJunctionsInTheTorusOwnCell) {
    Foam foam = raw_foam(60, 3);
    relax(foam, {});
    for (const Vec2& position : foam.positions) {
        EXPECT_TRUE(foam.domain.cell_of(position) == (LatticeOffset{0, 0}));
    }
}

TEST(Relaxation, FlipsFilmsAndCountsThem) {
    Foam foam = raw_foam(200, 2);
    const RelaxationSummary summary = relax(foam, {});
    EXPECT_GT(summary.t1, 0);
    EXPECT_TRUE(is_valid(foam.network));
}

TEST(Relaxation, HandlesUnequalAreas) {
    for (std::uint64_t seed = 1; seed <= 5; ++seed) {
        SeedingOptions seeding;
        seeding.bubbles = 100;
        seeding.area_ratio = 100.0;
        seeding.seed = seed;
        Foam foam = seed_foam(seeding);
        const ResidualNorms before = norms_of(foam);
        relax(foam, {});
        EXPECT_TRUE(is_valid(foam.network));
        EXPECT_LT(norms_of(foam).squares, 0.1 * before.squares);
    }
}

// Without sweeps, the pressures depend only on the areas: they are a common constant plus
//     B (1 - A / A_target) / sqrt(A_target),   B = 10 T (E4).
TEST(Relaxation, PressuresFollowTheMissingArea) {
    Foam foam = honeycomb(4, 4);
    foam.film_tension = 2.0;
    foam.target_areas[BubbleId{5}] = 1.21;
    relax(foam, {.sweeps = 0});
    const double common = foam.pressures[BubbleId{6}];
    EXPECT_NEAR(foam.pressures[BubbleId{5}] - common, 20.0 * (1.0 - 1.0 / 1.21) / 1.1, 1e-12);
    EXPECT_NEAR(foam.pressures[BubbleId{7}], common, 1e-12);
}

}  // namespace
}  // namespace foam
