// SPDX-License-Identifier: Apache-2.0

#include "texgen/maps/gradient_noise.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace foam::texgen {
namespace {

Vec2 sample_point(int k) {
    return {0.37 * k - 20.0, 0.23 * (k % 17) - 1.9};
}

TEST(GradientNoise, TheGradientIsItsDerivative) {
    constexpr double kStep = 1e-6;
    for (int k = 0; k < 100; ++k) {
        const Vec2 at = sample_point(k);
        const NoiseValue noise = gradient_noise(at.x(), at.y(), 7);
        const Vec2 gradient(noise.slope_x, noise.slope_y);
        for (int axis = 0; axis < 2; ++axis) {
            const Vec2 step = kStep * Vec2(1 - axis, axis);
            const double rise = gradient_noise(at.x() + step.x(), at.y() + step.y(), 7).value -
                                gradient_noise(at.x() - step.x(), at.y() - step.y(), 7).value;
            EXPECT_NEAR(gradient[axis], rise / (2.0 * kStep), 1e-6);
        }
    }
}

// Gradient noise is 0 at the points of its lattice. The mean over many points is near 0, and the
// values spread over most of the range from -1 to 1.
TEST(GradientNoise, IsCenteredAndFillsItsRange) {
    EXPECT_EQ(gradient_noise(3.0, -2.0, 1).value, 0.0);
    double sum = 0.0;
    double largest = 0.0;
    constexpr int kPoints = 10000;
    for (int k = 0; k < kPoints; ++k) {
        const double value = kNoiseScale * gradient_noise(0.131 * k, 0.173 * (k % 997), 3).value;
        sum += value;
        largest = std::max(largest, std::abs(value));
    }
    EXPECT_NEAR(sum / kPoints, 0.0, 0.02);
    EXPECT_GT(largest, 0.7);
    EXPECT_LE(largest, 1.0);
}

}  // namespace
}  // namespace foam::texgen
