// SPDX-License-Identifier: Apache-2.0

#include "texgen/raster/distance/pixel_mask.h"

#include "tests/support/simd_levels.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

namespace foam::texgen {
namespace {

// An arc of an outline, in subpixels.
struct Side {
    Vec2 from;
    Vec2 to;
    double half_angle;
};

Side arc_between(const Vec2& from, const Vec2& to, double half_angle) {
    return {from, to, half_angle};
}

void flip(const std::vector<Side>& sides, bool is_chain, PixelMask& mask) {
    const Vec2 offset(77.0, -1000.0);
    Boundary boundary;
    for (const Side& side : sides) {
        boundary.add_edge({side.from - offset,
                           side.to - offset,
                           std::cos(side.half_angle),
                           std::sin(side.half_angle)});
    }
    mask.flip_right_of(boundary.outline(), offset, is_chain);
}

PixelMask mask_of(const std::vector<Side>& sides, int columns, PixelRows rows) {
    PixelMask mask;
    mask.reset(columns, rows);
    flip(sides, false, mask);
    return mask;
}

bool holds(const PixelMask& mask, int x, int y) {
    return ((mask.word(x / PixelMask::kWordColumns, y) >> (x % PixelMask::kWordColumns)) & 1) != 0;
}

// A chord at any angle divides the circle into two arcs, of less and of more than half a turn. They
// rise, fall, or do both. `radius` is in pixels; a row of the circle is in one or in several words
// of the mask.
void expect_circles(double radius) {
    const int side = static_cast<int>(2.0 * radius + 10.0);
    const Vec2 center = Vec2(0.5 * side, 0.5 * side - 1.0);
    const auto on_circle = [&](double angle) -> Vec2 {
        const Vec2 at = center + radius * Vec2(std::cos(angle), std::sin(angle));
        return (kSubpixel * at.array()).round();
    };
    for (const double half_angle : {0.3, 0.9, 1.5, 1.9, 2.8}) {
        for (int turn = 0; turn < 12; ++turn) {
            const double middle = 2.0 * std::numbers::pi * turn / 12.0;
            const Vec2 from = on_circle(middle - half_angle);
            const Vec2 to = on_circle(middle + half_angle);
            const PixelMask mask = mask_of({arc_between(from, to, half_angle),
                                            arc_between(to, from, std::numbers::pi - half_angle)},
                                           side,
                                           {0, side});
            for (int y = 0; y < side; ++y) {
                for (int x = 0; x < side; ++x) {
                    const double distance = (Vec2(x + 0.5, y + 0.5) - center).norm();
                    if (std::abs(distance - radius) > 3.0 / kSubpixel) {
                        ASSERT_EQ(holds(mask, x, y), distance < radius) << x << ", " << y;
                    }
                }
            }
        }
    }
}

TEST(PixelMask, HoldsThePixelsOfACircle) {
    at_every_simd_level([] {
        expect_circles(15.3);
        expect_circles(70.7);
    });
}

// Two regions share a side, which is straight or bent to either side. Each pixel of the two regions
// is in exactly one of them.
TEST(PixelMask, GivesEachPixelAlongASharedSideToOneRegion) {
    constexpr int kSide = 40;
    const Vec2 a{5200, 3100};
    const Vec2 b{30500, 33333};
    const Vec2 left{1000, 35000};
    const Vec2 right{39000, 2000};
    at_every_simd_level([&] {
        for (const double half_angle : {-1.2, -0.4, 0.0, 0.7, 1.3}) {
            const PixelMask one = mask_of(
                {arc_between(a, b, half_angle), arc_between(b, left, 0), arc_between(left, a, 0)},
                kSide,
                {0, kSide});
            const PixelMask two = mask_of({arc_between(b, a, -half_angle),
                                           arc_between(a, right, 0),
                                           arc_between(right, b, 0)},
                                          kSide,
                                          {0, kSide});
            const PixelMask both = mask_of({arc_between(b, left, 0),
                                            arc_between(left, a, 0),
                                            arc_between(a, right, 0),
                                            arc_between(right, b, 0)},
                                           kSide,
                                           {0, kSide});
            for (int y = 0; y < kSide; ++y) {
                ASSERT_EQ(one.word(0, y) ^ two.word(0, y), both.word(0, y));
            }
        }
    });
}

std::vector<Side> square(double low, double high) {
    return {arc_between({low, low}, {high, low}, 0.0),
            arc_between({high, low}, {high, high}, 0.0),
            arc_between({high, high}, {low, high}, 0.0),
            arc_between({low, high}, {low, low}, 0.0)};
}

// The corners of the square are centers of pixels. The mask contains the centers on its left and
// lower sides.
TEST(PixelMask, CountsACenterOnASideAsToItsRight) {
    const PixelMask mask = mask_of(square(512.0, 512.0 + 2048.0), 4, {0, 4});
    for (int y = 0; y < 4; ++y) {
        EXPECT_EQ(mask.word(0, y), y < 2 ? 3U : 0U);
    }
}

// The edge crosses the middle of row 0 at 512.25 subpixels, a quarter of a subpixel beyond the
// center of pixel 0. The center is therefore on the left of the edge. If the crossing is rounded,
// the center is on the right.
TEST(PixelMask, DoesNotRoundTheCrossingsOfAnEdge) {
    const Vec2 low(512.0, 510.0);
    const Vec2 high(513.0, 518.0);
    PixelMask exact;
    exact.reset(4, {0, 1});
    flip({arc_between(low, high, 0.0)}, true, exact);
    EXPECT_EQ(exact.word(0, 0) & 15, 14U);
    EXPECT_EQ(mask_of({arc_between(low, high, 0.0)}, 4, {0, 1}).word(0, 0) & 15, 15U);
}

TEST(PixelMask, HoldsOnlyItsOwnRowsAndColumns) {
    const PixelMask mask = mask_of(square(-9e6, 9e9), 70, {7, 12});
    for (int y = 7; y < 12; ++y) {
        std::vector<std::pair<int, int>> spans;
        mask.for_each_span(y, [&](int column, int count) { spans.emplace_back(column, count); });
        EXPECT_EQ(spans, (std::vector<std::pair<int, int>>{{0, 64}, {64, 6}}));
        EXPECT_EQ(mask.word(1, y), 63U);
    }
}

TEST(PixelMask, StartsFullForARegionWithoutEnd) {
    PixelMask mask;
    mask.reset(100, {0, 5}, true);
    std::vector<Side> hole = square(2048.0, 4096.0);
    for (Side& side : hole) {  // the hole is on the right of its sides
        std::swap(side.from, side.to);
    }
    flip(hole, false, mask);
    for (int y = 0; y < 5; ++y) {
        for (int x = 0; x < 128; ++x) {
            const bool in_hole = x >= 2 && x < 4 && y >= 2 && y < 4;
            EXPECT_EQ(holds(mask, x, y), x < 100 && !in_hole) << x << ", " << y;
        }
    }
}

}  // namespace
}  // namespace foam::texgen
