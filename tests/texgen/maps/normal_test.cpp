// SPDX-License-Identifier: Apache-2.0

#include "texgen/maps/normal.h"

#include "tests/texgen/keys/limits.h"
#include "tests/texgen/maps/lone_circle.h"
#include "tests/texgen/maps/map_subjects.h"
#include "tests/texgen/maps/spherical_cap.h"
#include "texgen/maps/all_maps.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <variant>

namespace foam::texgen {
namespace {

const ReliefOptions kRelief;
const MazeOptions kMaze;

using test::LoneCircle;

constexpr double kRadius = 25.0;  // pixels

TEST(Normal, ALoneBubblesDomeIsACap) {
    LoneCircle circle(kRadius);
    const test::SphericalCap cap{kRadius};
    const NumberPixels normal = draw_normal(circle.layers, {kRelief, kMaze}, {});
    test::for_each_inside(kRadius, [&](int x, int y, const Vec2& point) {
        const auto n = normal.pixels.pixel(x, y);
        EXPECT_NEAR(n[0], point.x() / cap.sphere, 1e-3);
        EXPECT_NEAR(n[1], point.y() / cap.sphere, 1e-3);
        EXPECT_NEAR(n[2], std::sqrt(1.0 - point.squaredNorm() / (cap.sphere * cap.sphere)), 1e-3);
    });
    EXPECT_EQ(normal.pixels.pixel(0, 0)[2], 1.0F);
}

TEST(Normal, DirectXNormalsPointDown) {
    FrameInput input = test::torus_subject().input();
    input.distance = {.gradient = true, .smooth = SmoothImages::DistanceAndGradient};
    FrameLayers layers(input, test::torus_grid(64), 1);
    const auto up = draw_normal(layers, {kRelief, kMaze}, {.y = NormalY::Up});
    const auto down = draw_normal(layers, {kRelief, kMaze}, {.y = NormalY::Down});
    for (std::size_t k = 0; k < up.pixels.samples().size(); ++k) {
        const float sign = k % 3 == 1 ? -1.0F : 1.0F;
        ASSERT_EQ(up.pixels.samples()[k], sign * down.pixels.samples()[k]);
    }
}

TEST(Normal, BothDirectionsAreMapsOfTheirOwn) {
    const MapOptions options;
    const auto pixels = [&](const char* map, const MapOptions& chosen) {
        return std::get<NumberPixels>(
                   test::draw(map, test::torus_subject(), test::torus_grid(64), 1, chosen))
            .pixels;
    };
    MapOptions down;
    down.normal.y = NormalY::Down;
    EXPECT_EQ(pixels("normal_gl", down), pixels("normal", options));
    EXPECT_EQ(pixels("normal_dx", options), pixels("normal", down));
    EXPECT_EQ(find_map("normal_dx").note(options), "y down (DirectX)");
}

TEST(Normal, ChoicesHaveTheirWords) {
    test::expect_words(normal_keys(), "y", {"gl", "dx"});
}

}  // namespace
}  // namespace foam::texgen
