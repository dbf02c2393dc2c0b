// SPDX-License-Identifier: Apache-2.0

#include "texgen/maps/motion.h"

#include "core/dynamics/shear.h"
#include "core/foam/honeycomb.h"
#include "tests/support/sample_foams.h"
#include "tests/texgen/keys/limits.h"
#include "tests/texgen/maps/map_subjects.h"

#include <gtest/gtest.h>

#include <cmath>

namespace foam::texgen {
namespace {

constexpr int kSize = 64;

NumberPixels motion_of(const Frame& frame,
                       const Frame& next,
                       const RasterGrid& grid,
                       const MotionOptions& options = {.unit = MotionUnit::Pixels}) {
    const FoamRecord record;
    FrameLayers layers({frame, record, &next}, grid, 1);
    return draw_motion(layers, options);
}

// The whole foam is displaced by (0.3, -0.2) on the torus.
TEST(Motion, OfAFoamThatMovesAsAWholeIsTheSameEverywhere) {
    Foam foam = foam::test::polydisperse_foam(24, 5);
    const Frame frame = snapshot(foam, 1);
    for (const JunctionId junction : foam.network.junctions()) {
        place_junction(foam, junction, foam.positions[junction] + Vec2(0.3, -0.2));
    }
    const double scale = kSize / foam.domain.width;
    const NumberPixels image = motion_of(frame, snapshot(foam, 2), {kSize, kSize});
    for (int y = 0; y < kSize; ++y) {
        for (int x = 0; x < kSize; ++x) {
            ASSERT_NEAR(image.pixels.pixel(x, y)[0], 0.3 * scale, 1e-5) << x << " " << y;
            ASSERT_NEAR(image.pixels.pixel(x, y)[1], -0.2 * scale, 1e-5) << x << " " << y;
        }
    }
}

// Mean value coordinates reproduce linear functions, and the films of a honeycomb are straight. The
// motion of a shear by 0.05 is therefore 0.05 y.
TEST(Motion, OfAShearIsLinear) {
    Foam foam = honeycomb(4, 4);
    const double scale = kSize / foam.domain.width;
    const Frame frame = foam::test::fitted_frame(foam, kSize, kSize);
    foam.domain.height = frame.domain.height;
    foam.positions = frame.positions;
    shear(foam, 0.05);
    const NumberPixels image = motion_of(frame, snapshot(foam, 2), {kSize, kSize});
    for (int y = 8; y < kSize - 8; ++y) {  // bubbles on the border have the motion of one copy
        for (int x = 0; x < kSize; ++x) {
            ASSERT_NEAR(image.pixels.pixel(x, y)[0], 0.05 * (y + 0.5), 1e-3) << x << " " << y;
            ASSERT_NEAR(image.pixels.pixel(x, y)[1], 0.0, 1e-3) << x << " " << y;
        }
    }
    EXPECT_NEAR(snapshot(foam, 2).domain.shear_since(frame.domain) * scale, 0.05 * kSize, 1e-9);
}

TEST(Motion, UnitsAndDirectionsAreTheOnesAskedFor) {
    const auto draw_as = [](const MotionOptions& options) {
        FrameLayers layers(test::torus_subject().input(), test::torus_grid(kSize), 1);
        return draw_motion(layers, options);
    };
    const NumberPixels pixels = draw_as({.unit = MotionUnit::Pixels, .multiplier = {0.02}});
    const NumberPixels parts = draw_as({.unit = MotionUnit::Image, .y = MotionY::Down});
    EXPECT_NEAR(pixels.high, 0.02 * kSize, 1e-12);
    EXPECT_EQ(pixels.low, -pixels.high);
    EXPECT_EQ(parts.high, MotionOptions{}.multiplier.value);
    for (int x = 0; x < kSize; ++x) {
        const auto a = pixels.pixels.pixel(x, 11);
        const auto b = parts.pixels.pixel(x, 11);
        ASSERT_NEAR(a[0], kSize * b[0], 1e-5);
        ASSERT_NEAR(a[1], -kSize * b[1], 1e-5);
    }
}

// The circle moves by (0.5, 0) and its radius grows by a fifth.
TEST(Motion, ALoneBubbleMovesAndGrows) {
    const Frame frame = snapshot(foam::test::circles({{7, {0.0, 0.0}, std::numbers::pi}}), 1);
    const Frame next = snapshot(foam::test::circles({{7, {0.5, 0.0}, 1.44 * std::numbers::pi}}), 2);
    const NumberPixels image =
        motion_of(frame, next, {kSize, kSize, 0, 0, View{Vec2::Zero(), 20.0}});
    for (const int x : {14, 25, 40, 50}) {
        EXPECT_NEAR(image.pixels.pixel(x, 32)[0], 10.0 + 0.2 * (x + 0.5 - 32.0), 1e-5);
        EXPECT_NEAR(image.pixels.pixel(x, 32)[1], 0.2 * 0.5, 1e-5);
    }
    EXPECT_EQ(image.pixels.pixel(2, 2)[0], 0.0F);
}

TEST(Motion, LimitsHoldOnBothSides) {
    test::expect_limits(motion_keys(), {{"multiplier", "0", "1e-6", "10", "11"}});
}

TEST(Motion, ChoicesHaveTheirWords) {
    test::expect_words(motion_keys(), "unit", {"image", "px"});
    test::expect_words(motion_keys(), "y", {"up", "down"});
}

TEST(Motion, NeedsTheNextFrame) {
    FrameInput input = test::torus_subject().input();
    input.next = nullptr;
    FrameLayers layers(input, test::torus_grid(kSize), 1);
    EXPECT_THROW(draw_motion(layers, {}), std::invalid_argument);
}

}  // namespace
}  // namespace foam::texgen
