// SPDX-License-Identifier: Apache-2.0

#include "texgen/maps/sides.h"

#include "core/foam/honeycomb.h"
#include "tests/texgen/maps/lone_circle.h"

#include <gtest/gtest.h>

#include <cstdint>

namespace foam::texgen {
namespace {

using test::LoneCircle;

TEST(Sides, ALoneBubbleHasNoSides) {
    LoneCircle circle(20.0);
    const IdPixels sides = draw_sides(circle.layers);
    for (const std::uint32_t one : sides.pixels.samples()) {
        ASSERT_EQ(one, 0U);
    }
}

TEST(Sides, HexagonsHaveSix) {
    const Frame frame = foam::test::fitted_frame(honeycomb(4, 4), 64, 64);
    const FoamRecord record;
    FrameLayers layers({frame, record}, {64, 64}, 1);
    const IdPixels sides = draw_sides(layers);
    for (const std::uint32_t one : sides.pixels.samples()) {
        ASSERT_EQ(one, 6U);
    }
}

}  // namespace
}  // namespace foam::texgen
