// SPDX-License-Identifier: Apache-2.0

#include "texgen/maps/grain.h"

#include "tests/texgen/maps/lone_circle.h"
#include "tests/texgen/maps/map_subjects.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace foam::texgen {
namespace {

Vec2 sample_point(int k) {
    return {0.37 * k - 20.0, 0.23 * (k % 17) - 1.9};
}

TEST(Grain, TheGradientOfNoiseIsItsDerivative) {
    constexpr double kStep = 1e-6;
    for (int k = 0; k < 100; ++k) {
        const Vec2 at = sample_point(k);
        const Vec2 gradient = octave_noise(at, 7, 3).gradient;
        for (int axis = 0; axis < 2; ++axis) {
            const Vec2 step = kStep * Vec2(1 - axis, axis);
            const double rise =
                octave_noise(at + step, 7, 3).value - octave_noise(at - step, 7, 3).value;
            EXPECT_NEAR(gradient[axis], rise / (2.0 * kStep), 1e-6);
        }
    }
}

// Gradient noise is 0 at the points of its lattice. The mean over many points is near 0, and the
// values spread over most of the range from -1 to 1.
TEST(Grain, NoiseIsCenteredAndFillsItsRange) {
    EXPECT_EQ(octave_noise({3.0, -2.0}, 1, 1).value, 0.0);
    double sum = 0.0;
    double largest = 0.0;
    constexpr int kPoints = 10000;
    for (int k = 0; k < kPoints; ++k) {
        const double value = octave_noise({0.131 * k, 0.173 * (k % 997)}, 3, 1).value;
        sum += value;
        largest = std::max(largest, std::abs(value));
    }
    EXPECT_NEAR(sum / kPoints, 0.0, 0.02);
    EXPECT_GT(largest, 0.7);
    EXPECT_LE(largest, 1.0);
}

// The mean is added to every value in the bubble, but not around the patch.
TEST(Grain, ItsMeanIsAdded) {
    test::LoneCircle circle(25.0);
    const Grain plain(circle.layers, 0.2, GrainUse::Relief);
    const Grain raised(circle.layers, 0.2, GrainUse::Relief, 3.0);
    const auto middle = static_cast<std::size_t>(32 * test::kCircleImage + 30);
    EXPECT_DOUBLE_EQ(raised.at(middle).value, plain.at(middle).value + 3.0);
    EXPECT_EQ(raised.at(middle).gradient, plain.at(middle).gradient);
    EXPECT_EQ(raised.at(0).value, 0.0);
}

// A lone bubble has its grain in its circle, relative to its center.
TEST(Grain, ThereIsNoneAroundAPatch) {
    test::LoneCircle circle(25.0);
    const Grain grain(circle.layers, 0.2, GrainUse::Relief);
    EXPECT_EQ(grain.at(0).value, 0.0);
    EXPECT_EQ(grain.at(0).gradient, Vec2(0.0, 0.0));
    const auto middle = static_cast<std::size_t>(32 * test::kCircleImage + 30);
    EXPECT_NE(grain.at(middle).value, 0.0);
}

// The two uses have different grains.
TEST(Grain, UsesAreIndependent) {
    const test::MapSubject& subject = test::torus_subject();
    FrameLayers layers(subject.input(), test::torus_grid(64), 1);
    const Grain relief(layers, 0.5, GrainUse::Relief);
    const Grain albedo(layers, 0.5, GrainUse::Albedo);
    double products = 0.0;
    double squares = 0.0;
    for (std::size_t k = 0; k < 64U * 64U; ++k) {
        products += relief.at(k).value * albedo.at(k).value;
        squares += relief.at(k).value * relief.at(k).value;
    }
    EXPECT_LT(std::abs(products), 0.2 * squares);
}

}  // namespace
}  // namespace foam::texgen
