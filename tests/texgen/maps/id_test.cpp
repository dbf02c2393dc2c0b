// SPDX-License-Identifier: Apache-2.0

#include "texgen/maps/id.h"

#include "core/foam/honeycomb.h"
#include "tests/texgen/maps/lone_circle.h"

#include <gtest/gtest.h>

#include <array>
#include <cstddef>
#include <cstdint>

namespace foam::texgen {
namespace {

using test::LoneCircle;

constexpr double kRadius = 25.0;  // pixels

TEST(Id, IsThatOfTheBubbleUnderEveryPixel) {
    LoneCircle circle(kRadius);
    const IdPixels id = draw_id(circle.layers);
    for (int x = 0; x < test::kCircleImage; ++x) {
        const bool inside = test::from_middle(x, 32).norm() < kRadius;
        EXPECT_EQ(id.pixels.pixel(x, 32)[0], inside ? 8U : 0U);
    }
}

// 16 equal hexagons have the same share of the pixels, and every pixel is in one of them.
TEST(Id, CoversATorus) {
    const Frame frame = foam::test::fitted_frame(honeycomb(4, 4), 64, 64);
    const FoamRecord record;
    FrameLayers layers({frame, record}, {64, 64}, 1);
    std::array<int, 17> pixels{};
    const IdPixels ids = draw_id(layers);
    for (const std::uint32_t one : ids.pixels.samples()) {
        ++pixels.at(one);
    }
    EXPECT_EQ(pixels[0], 0);
    for (std::size_t k = 1; k < pixels.size(); ++k) {
        EXPECT_NEAR(pixels[k], 64 * 64 / 16, 12);
    }
}

}  // namespace
}  // namespace foam::texgen
