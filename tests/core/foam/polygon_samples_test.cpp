// SPDX-License-Identifier: Apache-2.0

#include "core/foam/polygon_samples.h"

#include <gtest/gtest.h>

#include <array>
#include <utility>
#include <vector>

namespace foam {
namespace {

constexpr double kTolerance = 1e-12;

// The integrals of 1, x and y over the rectangle from (1, 2) to (4, 4) are 6, 15 and 18. Sums over
// centroids of triangles are exact for linear functions.
TEST(PolygonSamples, IntegrateLinearFunctionsExactly) {
    const std::vector<Vec2> rectangle{{1.0, 2.0}, {4.0, 2.0}, {4.0, 4.0}, {1.0, 4.0}};
    for (const double spacing : {10.0, 0.7, 0.01}) {
        double area = 0.0;
        Vec2 moment{0.0, 0.0};
        visit_polygon_samples(rectangle, spacing, [&](const Vec2& point, double weight) {
            area += weight;
            moment += weight * point;
        });
        EXPECT_NEAR(area, 6.0, kTolerance);
        EXPECT_NEAR(moment.x(), 15.0, kTolerance);
        EXPECT_NEAR(moment.y(), 18.0, kTolerance);
    }
}

// The longest side of the triangle is 5: a spacing of 1.25 divides each side into 4 parts, and the
// triangle into 16. The smallest spacing divides it into 32^2.
TEST(PolygonSamples, AreAsManyAsTheSpacingAsksFor) {
    const std::array<Vec2, 3> triangle{Vec2(0.0, 0.0), Vec2(3.0, 0.0), Vec2(0.0, 4.0)};
    for (const auto& [spacing, expected] :
         {std::pair(6.0, 1), std::pair(1.25, 16), std::pair(1e-6, 1024)}) {
        int samples = 0;
        visit_polygon_samples(triangle, spacing, [&](const Vec2& point, double) {
            ++samples;
            EXPECT_GT(point.x(), 0.0);
            EXPECT_GT(point.y(), 0.0);
            EXPECT_LT(point.x() / 3.0 + point.y() / 4.0, 1.0);
        });
        EXPECT_EQ(samples, expected);
    }
}

}  // namespace
}  // namespace foam
