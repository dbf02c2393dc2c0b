// SPDX-License-Identifier: Apache-2.0

#include "texgen/maps/relief.h"

#include "tests/texgen/maps/lone_circle.h"
#include "tests/texgen/maps/spherical_cap.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>

namespace foam::texgen {
namespace {

using test::LoneCircle;

constexpr double kRadius = 25.0;  // pixels

// The dome of a lone bubble with a radius of R pixels is a cap of a sphere of radius S = R / sin(50
// degrees). The slope at r is -r / sqrt(S² - r²).
TEST(Relief, SlopesAndHeightsAreThoseOfACap) {
    LoneCircle circle(kRadius);
    const Relief relief(circle.layers, {});
    const test::SphericalCap cap{kRadius};
    EXPECT_NEAR(relief.diameter(), 2.0 * kRadius, 1e-9);
    test::for_each_inside(kRadius, [&](int x, int y, const Vec2& point) {
        const auto index = static_cast<std::size_t>(y * test::kCircleImage + x);
        const double r = point.norm();
        EXPECT_NEAR(relief.unit(index), kRadius, 1e-9);
        EXPECT_NEAR(relief.height(index), cap.height(r), 5e-3);
        EXPECT_NEAR(
            relief.slope(index).norm(), r / std::sqrt(cap.sphere * cap.sphere - r * r), 5e-3);
    });
}

TEST(Relief, AroundAPatchADomeIsFlat) {
    LoneCircle circle(kRadius);
    const Relief relief(circle.layers, {});
    EXPECT_EQ(relief.unit(0), 0.0);
    EXPECT_EQ(relief.height(0), 0.0);
    EXPECT_EQ(relief.slope(0), Vec2(0.0, 0.0));
}

TEST(Relief, StrengthIsAFactor) {
    LoneCircle circle(kRadius);
    const Relief once(circle.layers, {});
    const Relief thrice(circle.layers, {.strength = 3.0});
    const std::size_t middle = 32 * test::kCircleImage + 40;
    EXPECT_DOUBLE_EQ(thrice.height(middle), 3.0 * once.height(middle));
}

}  // namespace
}  // namespace foam::texgen
