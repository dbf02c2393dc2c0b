// SPDX-License-Identifier: Apache-2.0

#include "texgen/image/normal_angles.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>
#include <string>
#include <vector>

namespace foam::texgen {
namespace {

/// Returns a picture of numbers, one pixel per three numbers, side by side.
Picture numbers(const std::vector<float>& samples) {
    Image<float> image(static_cast<int>(samples.size() / 3), 1, 3);
    std::ranges::copy(samples, image.samples().begin());
    return {{{{"X", "Y", "Z"}, SampleType::Float, image}}};
}

template <class Code>
Picture codes(const std::vector<Code>& samples) {
    Image<Code> image(static_cast<int>(samples.size() / 3), 1, 3);
    std::ranges::copy(samples, image.samples().begin());
    return {{code_channels(std::move(image))}};
}

// Angles of known vectors: equal, orthogonal, opposite, and 45 degrees with different lengths.
TEST(NormalAngles, AreThoseOfTheVectors) {
    const std::vector<double> angles =
        normal_angles(numbers({0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1}),
                      numbers({0, 0, 1, 1, 0, 0, 0, 0, -1, 0, 3, 3}));
    ASSERT_EQ(angles.size(), 4U);
    EXPECT_EQ(angles[0], 0.0);
    EXPECT_NEAR(angles[1], 90.0, 1e-12);
    EXPECT_NEAR(angles[2], 180.0, 1e-12);
    EXPECT_NEAR(angles[3], 45.0, 1e-12);
}

// The arc cosine of a dot product would give 0 here: it is 1 - 5e-15.
TEST(NormalAngles, SmallAnglesAreAccurate) {
    const double angle = normal_angles(numbers({0, 0, 1}), numbers({1e-7F, 0, 1})).front();
    EXPECT_NEAR(angle, 1e-7 * 180.0 / std::numbers::pi, 1e-12);
}

// The code 255 stands for 1, and 0 for -1. One step of the code of x turns (0, 0, 1) by about
// 2 / 255 radians. In 16 bits the step is 257 times smaller.
TEST(NormalAngles, CodesAreDecoded) {
    const double step = 2.0 / 255.0;
    const auto x_of = [](double code, double white) { return 2.0 * code / white - 1.0; };
    const double expected = std::atan2(x_of(129, 255), 1.0) - std::atan2(x_of(128, 255), 1.0);
    const auto a = codes<std::uint8_t>({128, 0, 255, 255, 128, 128});
    const auto b = codes<std::uint8_t>({129, 0, 255, 0, 127, 127});
    const std::vector<double> angles = normal_angles(a, b);
    EXPECT_LT(angles[0], expected * 180.0 / std::numbers::pi);  // y is -1, so the normal is longer
    EXPECT_GT(angles[0], 0.4 * step * 180.0 / std::numbers::pi);
    EXPECT_NEAR(angles[1], 180.0, 1e-9);  // (1, e, e) and (-1, -e, -e)
    EXPECT_NEAR(normal_angles(codes<std::uint16_t>({65535, 0, 0}),
                              codes<std::uint16_t>({65535, 65535, 65535}))
                    .front(),
                std::acos(-1.0 / 3.0) * 180.0 / std::numbers::pi,
                1e-12);
}

TEST(NormalAngles, ANormalWithoutDirectionIsTurnedFarthest) {
    const float nan = std::numeric_limits<float>::quiet_NaN();
    const std::vector<double> angles =
        normal_angles(numbers({0, 0, 0, 0, 0, 0, nan, 0, 1, nan, 0, 1}),
                      numbers({0, 0, 0, 0, 0, 1, nan, 0, 1, 0, 0, 1}));
    EXPECT_EQ(angles, (std::vector<double>{0.0, 180.0, 0.0, 180.0}));
}

TEST(NormalAngles, NormalsHaveThreeChannels) {
    EXPECT_TRUE(can_hold_normals(numbers({0, 0, 1})));
    EXPECT_FALSE(can_hold_normals({{code_channels(Image<std::uint8_t>(1, 1, 1))}}));
    EXPECT_FALSE(can_hold_normals({{code_channels(Image<std::uint8_t>(1, 1, 4))}}));
    Picture split;  // as an EXR is decoded: one group per channel
    for (const char* name : {"X", "Y", "Z"}) {
        split.groups.push_back({{name}, SampleType::Half, Image<float>(1, 1, 1)});
    }
    EXPECT_TRUE(can_hold_normals(split));
}

}  // namespace
}  // namespace foam::texgen
