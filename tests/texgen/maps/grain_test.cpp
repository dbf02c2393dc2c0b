// SPDX-License-Identifier: Apache-2.0

#include "texgen/maps/grain.h"

#include "tests/texgen/maps/lone_circle.h"
#include "tests/texgen/maps/map_subjects.h"
#include "texgen/maps/gradient_noise.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>

namespace foam::texgen {
namespace {

// Returns the sum of several octaves of noise at a point. The first octave has features of size 1.
// The features of each further octave have half the size and half the height.
NoiseValue octave_noise(const Vec2& point, std::uint32_t seed, int octaves) {
    NoiseValue sum;
    double size = 1.0;
    for (int k = 0; k < octaves; ++k) {
        const NoiseValue one =
            gradient_noise(point.x() / size, point.y() / size, seed_of_octave(seed, k));
        sum.value += kNoiseScale * size * one.value;
        sum.slope_x += kNoiseScale * one.slope_x;
        sum.slope_y += kNoiseScale * one.slope_y;
        size *= 0.5;
    }
    return sum;
}

constexpr auto kMiddle = static_cast<std::size_t>(32 * test::kCircleImage + 30);

// The mean is added to every value in the bubble, but not around the patch.
TEST(Grain, ItsMeanIsAdded) {
    test::LoneCircle circle(25.0);
    const Grain& plain = circle.layers.grain({0.2, GrainUse::Relief});
    const Grain& raised = circle.layers.grain({0.2, GrainUse::Relief, 3.0});
    EXPECT_NEAR(raised.value.samples()[kMiddle], plain.value.samples()[kMiddle] + 3.0F, 1e-6F);
    EXPECT_EQ(raised.slope_x, plain.slope_x);
    EXPECT_EQ(raised.slope_y, plain.slope_y);
    EXPECT_EQ(raised.value.samples()[0], 0.0F);
}

TEST(Grain, IsDrawnOnceForAllMaps) {
    test::LoneCircle circle(25.0);
    const GrainRule rule{0.2, GrainUse::Relief};
    const Grain& first = circle.layers.grain(rule);
    EXPECT_EQ(&circle.layers.grain(rule), &first);
    EXPECT_NE(&circle.layers.grain({0.2, GrainUse::Albedo}), &first);
}

TEST(Grain, ValuesWithoutSlopesAreTheSame) {
    const test::MapSubject& subject = test::torus_subject();
    FrameInput input = subject.input();
    const RasterGrid grid = test::torus_grid(64);
    const GrainRule rule{0.2, GrainUse::Relief};
    input.distance = {.smooth = SmoothImages::DistanceAndGradient};
    FrameLayers all(input, grid, 1);
    input.distance = {.smooth = SmoothImages::Distance};
    FrameLayers some(input, grid, 1);
    EXPECT_EQ(some.grain(rule).value, all.grain(rule).value);
    EXPECT_FALSE(all.grain(rule).slope_x.samples().empty());
    EXPECT_TRUE(some.grain(rule).slope_x.samples().empty());
    EXPECT_TRUE(some.grain(rule).slope_y.samples().empty());
    EXPECT_TRUE(all.grain({0.2, GrainUse::Albedo}).slope_x.samples().empty());
}

// A lone bubble has its grain in its circle, relative to its center.
TEST(Grain, ThereIsNoneAroundAPatch) {
    test::LoneCircle circle(25.0);
    const Grain& grain = circle.layers.grain({0.2, GrainUse::Relief});
    EXPECT_EQ(grain.value.samples()[0], 0.0F);
    EXPECT_EQ(grain.slope_x.samples()[0], 0.0F);
    EXPECT_EQ(grain.slope_y.samples()[0], 0.0F);
    EXPECT_NE(grain.value.samples()[kMiddle], 0.0F);
}

// The points of the noise are the centers of pixels, relative to the center of the bubble. There
// are three octaves: features of 11.3, 5.6 and 2.8 pixels are not smaller than two pixels.
TEST(Grain, IsTheSumOfOctavesAtTheCentersOfPixels) {
    constexpr double kRadius = 25.0;
    constexpr double kSize = 0.4;
    test::LoneCircle circle(kRadius);
    const double pixels =
        diameters_in_pixels(kSize, circle.layers.grid(), circle.layers.frame().domain);
    const Grain& grain = circle.layers.grain({kSize, GrainUse::Relief});
    test::for_each_inside(kRadius - 1.0, [&](int x, int y, const Vec2& point) {
        const auto index = static_cast<std::size_t>(y * test::kCircleImage + x);
        const NoiseValue noise =
            octave_noise(point / pixels, seed_of_grain(BubbleIdentity{7}, GrainUse::Relief), 3);
        EXPECT_NEAR(grain.value.samples()[index], noise.value, 1e-5);
        EXPECT_NEAR(grain.slope_x.samples()[index], noise.slope_x / pixels, 1e-5);
        EXPECT_NEAR(grain.slope_y.samples()[index], noise.slope_y / pixels, 1e-5);
    });
}

// In a magnified view, the center of a bubble may be millions of pixels away.
TEST(Grain, OfAFarBubbleIsRelativeToItsCenter) {
    constexpr double kRadius = 4e6;
    constexpr double kSize = 0.01;
    constexpr int kImage = 16;
    const Vec2 middle(-0.6, 0.7);  // of the image, in foam units
    const Frame frame = snapshot(foam::test::circles({{7, {0.0, 0.0}, std::numbers::pi}}), 1);
    const FoamRecord record{};
    FrameLayers layers(
        {frame, record, nullptr, {.gradient = true, .smooth = SmoothImages::DistanceAndGradient}},
        {kImage, kImage, 0, 0, View{middle, kRadius}},
        1);
    const double pixels = diameters_in_pixels(kSize, layers.grid(), frame.domain);
    const Grain& grain = layers.grain({kSize, GrainUse::Relief});
    for (int k = 0; k < kImage; ++k) {
        const Vec2 point = kRadius * middle + Vec2::Constant(k + 0.5 - 0.5 * kImage);
        const NoiseValue noise =
            octave_noise(point / pixels, seed_of_grain(BubbleIdentity{7}, GrainUse::Relief), 5);
        EXPECT_NEAR(grain.value.pixel(k, k)[0], noise.value, 1e-5);
        EXPECT_NEAR(grain.slope_x.pixel(k, k)[0], noise.slope_x / pixels, 1e-9);
    }
}

// The two uses have different grains.
TEST(Grain, UsesAreIndependent) {
    const test::MapSubject& subject = test::torus_subject();
    FrameLayers layers(subject.input(), test::torus_grid(64), 1);
    const Grain& relief = layers.grain({0.5, GrainUse::Relief});
    const Grain& albedo = layers.grain({0.5, GrainUse::Albedo});
    double products = 0.0;
    double squares = 0.0;
    for (std::size_t k = 0; k < 64U * 64U; ++k) {
        const auto value = static_cast<double>(relief.value.samples()[k]);
        products += value * static_cast<double>(albedo.value.samples()[k]);
        squares += value * value;
    }
    EXPECT_LT(std::abs(products), 0.2 * squares);
}

}  // namespace
}  // namespace foam::texgen
