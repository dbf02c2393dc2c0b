// SPDX-License-Identifier: Apache-2.0

#include "texgen/pictures/svg_viewport.h"

#include <gtest/gtest.h>

#include <array>

namespace foam::texgen {
namespace {

constexpr const char* kBox = "10 20,100 50";  // from (10, 20) to (110, 70)

// Returns the images of two opposite corners of the view box in a viewport of 400 x 100, as
// (left, top, right, bottom).
std::array<double, 4> corners(const char* aspect_ratio) {
    const AffineMap map = view_box_map(*parse_svg_view_box(kBox), aspect_ratio, {400.0, 100.0});
    const Vec2 low = map({10.0, 20.0});
    const Vec2 high = map({110.0, 70.0});
    return {low.x(), low.y(), high.x(), high.y()};
}

using Corners = std::array<double, 4>;

// The view box fits into the viewport with the scale 2, and covers it with the scale 4.
TEST(SvgViewport, KeepsTheAspectRatioUnlessItIsNone) {
    EXPECT_EQ(corners(""), (Corners{100.0, 0.0, 300.0, 100.0}));
    EXPECT_EQ(corners("xMidYMid meet"), corners(""));
    EXPECT_EQ(corners("xMinYMax"), (Corners{0.0, 0.0, 200.0, 100.0}));
    EXPECT_EQ(corners("xMaxYMid"), (Corners{200.0, 0.0, 400.0, 100.0}));
    EXPECT_EQ(corners("xMidYMid slice"), (Corners{0.0, -50.0, 400.0, 150.0}));
    EXPECT_EQ(corners("xMidYMin slice"), (Corners{0.0, 0.0, 400.0, 200.0}));
    EXPECT_EQ(corners("xMidYMax slice"), (Corners{0.0, -100.0, 400.0, 100.0}));
    EXPECT_EQ(corners("none"), (Corners{0.0, 0.0, 400.0, 100.0}));
}

TEST(SvgViewport, AViewBoxHasFourNumbers) {
    EXPECT_EQ(parse_svg_view_box(kBox)->low, Vec2(10.0, 20.0));
    EXPECT_EQ(parse_svg_view_box(kBox)->size, Vec2(100.0, 50.0));
    EXPECT_FALSE(parse_svg_view_box(""));
    EXPECT_FALSE(parse_svg_view_box("0 0 10"));
    EXPECT_FALSE(parse_svg_view_box("0 0 auto auto"));
}

}  // namespace
}  // namespace foam::texgen
