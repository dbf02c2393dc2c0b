// SPDX-License-Identifier: Apache-2.0

#include "texgen/maps/fade_order.h"

#include "tests/texgen/maps/seam.h"
#include "texgen/verify/verify.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace foam::texgen {
namespace {

FadeOrder::Options options_of(double spread) {
    return {.width = 160, .height = 96, .bubbles = 300.0, .spread = spread, .seed = 7};
}

double mean(const Image<float>& image) {
    double sum = 0.0;
    for (const float sample : image.samples()) {
        sum += sample;
    }
    return sum / static_cast<double>(image.samples().size());
}

/// Returns the fraction of the pixels whose weight is neither 0 nor 1.
double between(const Image<float>& weights) {
    const auto count = std::ranges::count_if(
        weights.samples(), [](float weight) { return weight > 0.0F && weight < 1.0F; });
    return static_cast<double>(count) / static_cast<double>(weights.samples().size());
}

TEST(FadeOrder, WeightsGoFromZeroToOne) {
    for (const double spread : {0.0, 0.8, 0.95}) {
        const FadeOrder order(options_of(spread));
        const Image<float> first = order.weights(0.0);
        EXPECT_EQ(std::ranges::max(first.samples()), 0.0F) << spread;
        const Image<float> last = order.weights(1.0);
        EXPECT_GE(std::ranges::min(last.samples()), 1.0F - 1e-6F) << spread;
        EXPECT_LE(std::ranges::max(last.samples()), 1.0F) << spread;
        double before = 0.0;
        for (int k = 1; k <= 10; ++k) {
            const double weight = mean(order.weights(0.1 * k));
            EXPECT_GT(weight, before) << spread;
            before = weight;
        }
    }
}

// The weights are 3 x² - 2 x³ for x = 1/4, 1/2 and 3/4.
TEST(FadeOrder, WithoutSpreadItIsLevelAtItsEnds) {
    const FadeOrder order(options_of(0.0));
    for (const auto& [passed, weight] :
         {std::pair{0.25, 0.15625F}, {0.5, 0.5F}, {0.75, 0.84375F}}) {
        const Image<float> found = order.weights(passed);
        EXPECT_FLOAT_EQ(std::ranges::min(found.samples()), weight);
        EXPECT_FLOAT_EQ(std::ranges::max(found.samples()), weight);
    }
}

// Each pixel fades during a fifth of the time, because the spread is 0.8. A fifth to a quarter of
// the pixels fade at any moment.
TEST(FadeOrder, OnlyAPartOfTheFoamIsBetween) {
    const FadeOrder order(options_of(0.8));
    for (const double passed : {0.3, 0.5, 0.7}) {
        const Image<float> weights = order.weights(passed);
        EXPECT_GT(between(weights), 0.12) << passed;
        EXPECT_LT(between(weights), 0.4) << passed;
        EXPECT_NEAR(mean(weights), passed, 0.15) << passed;
    }
    EXPECT_EQ(between(FadeOrder(options_of(0.0)).weights(0.5)), 1.0);
}

TEST(FadeOrder, HasNoSeam) {
    const Image<float> weights = FadeOrder(options_of(0.8)).weights(0.5);
    EXPECT_LE(test::seam_ratio(weights), kLargestTileRatio);
    EXPECT_GT(test::seam_ratio(weights, 0.5), kLargestTileRatio);
}

TEST(FadeOrder, DependsOnTheSeed) {
    FadeOrder::Options options = options_of(0.8);
    const Image<float> one = FadeOrder(options).weights(0.5);
    EXPECT_EQ(FadeOrder(options).weights(0.5), one);
    options.seed = 8;
    EXPECT_NE(FadeOrder(options).weights(0.5), one);
}

// A tile of one pixel has only one rank.
TEST(FadeOrder, TheSmallestTileFades) {
    const FadeOrder order({.width = 1, .height = 1, .bubbles = 1.0, .spread = 0.5, .seed = 1});
    EXPECT_EQ(order.weights(0.0).samples()[0], 0.0F);
    EXPECT_GE(order.weights(1.0).samples()[0], 1.0F - 1e-6F);
}

}  // namespace
}  // namespace foam::texgen
