// SPDX-License-Identifier: Apache-2.0

#include "texgen/maps/mean_bubble.h"

#include "tests/texgen/maps/lone_circle.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace foam::texgen {
namespace {

using test::LoneCircle;

// The lone bubble has the area pi, so its diameter is 2.
TEST(MeanBubble, IsOfTheSeedOrOfTheFrame) {
    const LoneCircle circle(20.0);
    EXPECT_EQ(area_of(MeanBubble::Seed, circle.frame), 1.0);
    EXPECT_NEAR(area_of(MeanBubble::Current, circle.frame), std::numbers::pi, 1e-12);
    EXPECT_NEAR(diameter_of(MeanBubble::Current, circle.frame), 2.0, 1e-12);
    EXPECT_NEAR(
        diameter_of(MeanBubble::Seed, circle.frame), 2.0 / std::sqrt(std::numbers::pi), 1e-12);
}

TEST(MeanBubble, AnEmptyFrameIsMeasuredByTheSeed) {
    LoneCircle circle(20.0);
    circle.frame.lone_bubbles.clear();
    EXPECT_EQ(area_of(MeanBubble::Current, circle.frame), 1.0);
}

}  // namespace
}  // namespace foam::texgen
