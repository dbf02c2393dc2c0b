// SPDX-License-Identifier: Apache-2.0

#include "texgen/image/oklab.h"

#include <gtest/gtest.h>

namespace foam::texgen {
namespace {

TEST(Oklab, HasNoHueForGray) {
    const Oklab white = to_oklab({1.0, 1.0, 1.0});
    EXPECT_NEAR(white.lightness, 1.0, 1e-6);
    EXPECT_NEAR(white.a, 0.0, 1e-6);
    EXPECT_NEAR(white.b, 0.0, 1e-6);
    EXPECT_NEAR(to_oklab({0.125, 0.125, 0.125}).lightness, 0.5, 1e-6);  // the cube root
}

// The coordinates of pure red, from B. Ottosson's article: L = 0.628, a = 0.225, b = 0.126.
TEST(Oklab, AgreesWithThePublishedColors) {
    const Oklab red = to_oklab({1.0, 0.0, 0.0});
    EXPECT_NEAR(red.lightness, 0.628, 5e-4);
    EXPECT_NEAR(red.a, 0.225, 5e-4);
    EXPECT_NEAR(red.b, 0.126, 5e-4);
}

TEST(Oklab, ConvertsBack) {
    const LinearRgb color{0.2, 0.7, 0.05};
    const LinearRgb back = to_linear(to_oklab(color));
    EXPECT_NEAR(back.r, color.r, 1e-6);
    EXPECT_NEAR(back.g, color.g, 1e-6);
    EXPECT_NEAR(back.b, color.b, 1e-6);
}

}  // namespace
}  // namespace foam::texgen
