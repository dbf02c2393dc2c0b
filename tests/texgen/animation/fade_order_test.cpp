// SPDX-License-Identifier: Apache-2.0

#include "texgen/animation/fade_order.h"

#include "tests/support/sample_foams.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace foam::texgen {
namespace {

FadeOrder::Options options_of(double spread) {
    return {.bubbles = 300.0, .spread = spread, .aspect = 1.0, .seed = 7};
}

const Foam& large_foam() {
    static const Foam foam = foam::test::polydisperse_foam(300, 4);
    return foam;
}

std::vector<double> ranks_of(const FadeOrder& order, const Foam& foam, const Vec2& displacement) {
    return order.ranks(snapshot(foam, 1), displacement);
}

// Each bubble grows during a fifth of the cross-fade, because the spread is 0.8.
TEST(FadeOrder, GrowthGoesFromZeroToOne) {
    const FadeOrder order(options_of(0.8));
    for (const double rank : {0.0, 0.5, 1.0}) {
        EXPECT_EQ(order.growth(rank, 0.0), 0.0);
        EXPECT_EQ(order.growth(rank, 1.0), 1.0);
        EXPECT_NEAR(order.growth(rank, 0.8 * rank), 0.0, 1e-12);
        EXPECT_NEAR(order.growth(rank, 0.8 * rank + 0.05), 0.25, 1e-12);
        EXPECT_NEAR(order.growth(rank, 0.8 * rank + 0.2), 1.0, 1e-12);
    }
    EXPECT_EQ(FadeOrder(options_of(0.0)).growth(0.9, 0.25), 0.25);
}

TEST(FadeOrder, RanksAreSpreadOverTheFade) {
    std::vector<double> ranks = ranks_of(FadeOrder(options_of(0.8)), large_foam(), Vec2::Zero());
    ASSERT_EQ(ranks.size(), 300U);
    std::ranges::sort(ranks);
    EXPECT_GE(ranks.front(), 0.0);
    EXPECT_LE(ranks.back(), 1.0);
    for (const double part : {0.25, 0.5, 0.75}) {
        EXPECT_NEAR(ranks[static_cast<std::size_t>(300 * part)], part, 0.15);
    }
}

// Bubbles on both sides of a film have similar ranks.
TEST(FadeOrder, NeighborsHaveSimilarRanks) {
    const Frame frame = snapshot(large_foam(), 1);
    const std::vector<double> ranks = FadeOrder(options_of(0.8)).ranks(frame, Vec2::Zero());
    double sum = 0.0;
    for (const FilmId film : frame.network.films()) {
        const HalfEdgeId side = forward_side(film);
        sum += std::abs(ranks[index_of(frame.network.left(side))] -
                        ranks[index_of(frame.network.right(side))]);
    }
    // Two independent ranks would differ by 1/3 on average.
    EXPECT_LT(sum / static_cast<double>(frame.network.film_count()), 0.2);
}

// A displaced foam whose displacement is known keeps its ranks, also across the border of the
// torus.
TEST(FadeOrder, ADriftDoesNotChangeRanks) {
    const FadeOrder order(options_of(0.8));
    const std::vector<double> still = ranks_of(order, large_foam(), Vec2::Zero());
    Foam foam = large_foam();
    const Vec2 by(7.3, -2.9);
    translate(foam, by);
    const std::vector<double> moved = ranks_of(order, foam, by);
    for (std::size_t k = 0; k < still.size(); ++k) {
        EXPECT_NEAR(moved[k], still[k], 1e-9) << k;
    }
}

TEST(FadeOrder, DependsOnTheSeed) {
    FadeOrder::Options options = options_of(0.8);
    const std::vector<double> one = ranks_of(FadeOrder(options), large_foam(), Vec2::Zero());
    EXPECT_EQ(ranks_of(FadeOrder(options), large_foam(), Vec2::Zero()), one);
    options.seed = 8;
    EXPECT_NE(ranks_of(FadeOrder(options), large_foam(), Vec2::Zero()), one);
}

}  // namespace
}  // namespace foam::texgen
