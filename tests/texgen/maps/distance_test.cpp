// SPDX-License-Identifier: Apache-2.0

#include "texgen/maps/distance.h"

#include "tests/texgen/keys/limits.h"
#include "tests/texgen/maps/lone_circle.h"

#include <gtest/gtest.h>

namespace foam::texgen {
namespace {

using test::LoneCircle;

constexpr double kRadius = 25.0;  // pixels

TEST(Distance, IsToTheCircle) {
    LoneCircle circle(kRadius);
    const auto in_pixels =
        draw_distance(circle.layers, {.unit = DistanceUnit::Pixels}, AlbedoOptions{});
    const auto in_units = draw_distance(circle.layers, {}, AlbedoOptions{});
    test::for_each_inside(kRadius, [&](int x, int y, const Vec2& point) {
        const double expected = kRadius - point.norm();
        EXPECT_NEAR(in_pixels.pixels.pixel(x, y)[0], expected, 1e-4);
        EXPECT_NEAR(in_units.pixels.pixel(x, y)[0], expected / kRadius, 1e-5);
    });
    EXPECT_EQ(in_pixels.pixels.pixel(0, 0)[0], 0.0F);
}

// The signed distance is measured from the edge of the film, which is 3 pixels wide. It is negative
// around the patch.
TEST(Distance, SignedDistanceIsFromTheEdge) {
    LoneCircle circle(kRadius);
    AlbedoOptions films;
    films.film_width = 3.0;
    const auto image = draw_distance(
        circle.layers, {.kind = DistanceKind::Signed, .unit = DistanceUnit::Pixels}, films);
    for (const int x : {0, 5, 20, 32}) {
        const double expected = kRadius - test::from_middle(x, 32).norm() - 1.5;
        EXPECT_NEAR(image.pixels.pixel(x, 32)[0], expected, 1e-4) << x;
    }
    EXPECT_EQ(image.low, -image.high);
}

// There is no film to measure from.
TEST(Distance, OfAnEmptyPatchIsFinite) {
    const Frame frame = snapshot(foam::test::circles({}), 1);
    const FoamRecord record;
    FrameLayers layers({frame, record}, {8, 8, 0, 0, View{Vec2::Zero(), 1.0}}, 1);
    const auto plain = draw_distance(layers, {}, AlbedoOptions{});
    EXPECT_EQ(plain.pixels.pixel(3, 4)[0], 0.0F);
    const auto signed_distance =
        draw_distance(layers, {.kind = DistanceKind::Signed, .full = {2.5}}, AlbedoOptions{});
    EXPECT_EQ(signed_distance.pixels.pixel(3, 4)[0], -2.5F);
}

TEST(Distance, LimitsHoldOnBothSides) {
    test::expect_limits(distance_keys(), {{"full", "0", "1e-6", "1e6", "1e7"}});
}

TEST(Distance, ChoicesHaveTheirWords) {
    test::expect_words(distance_keys(), "kind", {"plain", "signed"});
    test::expect_words(distance_keys(), "unit", {"foam", "px"});
}

}  // namespace
}  // namespace foam::texgen
