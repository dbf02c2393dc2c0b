// SPDX-License-Identifier: Apache-2.0

#include "texgen/raster/coverage/arc_splitter.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <map>
#include <numbers>
#include <random>
#include <span>
#include <utility>
#include <vector>

namespace foam::texgen {
namespace {

// Returns a straight edge. These tests do not use its sides.
MonotoneArc edge(SubpixelPoint low, SubpixelPoint high) {
    return {low, high, 0.0, {}};
}

// For each pixel (row, column), the sums of the heights of the parts in it, in subpixels, and of
// ArcSplitter::Part::on_left.
using Parts = std::map<std::pair<int, int>, std::pair<int, std::int64_t>>;

// Returns the sums over the parts of an arc that is moved by a translation, in the rows [0, rows).
Parts split_parts(const MonotoneArc& arc, SubpixelPoint translation, int rows) {
    Parts parts;
    ArcSplitter splitter(rows);
    if (!splitter.is_in_rows(arc, translation)) {
        return parts;
    }
    splitter.add(arc, translation);
    splitter.split();
    for (const ArcSplitter::Part& part : splitter.parts(0)) {
        EXPECT_LE(splitter.leftmost(0), part.column);
        EXPECT_GE(splitter.rightmost(0), part.column);
        if (part.twice_area == 0) {
            EXPECT_EQ(part.twice_area_on_left, 0);
            continue;
        }
        auto& [height, area] = parts[{part.row, part.column}];
        height += part.twice_area / (2 * kSubpixel);
        area += part.twice_area_on_left;
    }
    return parts;
}

// Returns the sums over the straight edges of a closed chain. Edges that go down have the sign -1.
Parts split_parts(const std::vector<SubpixelPoint>& chain, SubpixelPoint translation, int rows) {
    Parts all;
    SubpixelPoint from = chain.back();
    for (const SubpixelPoint to : chain) {
        const int sign = from.y < to.y ? 1 : -1;
        const auto parts = from.y == to.y  ? Parts{}
                           : from.y < to.y ? split_parts(edge(from, to), translation, rows)
                                           : split_parts(edge(to, from), translation, rows);
        for (const auto& [pixel, part] : parts) {
            all[pixel].first += sign * part.first;
            all[pixel].second += sign * part.second;
        }
        from = to;
    }
    return all;
}

TEST(ArcSplitter, KeepsASquareInOnePixel) {
    // The square is half a pixel wide and high, counter-clockwise. Its left side is at x = 256 and
    // goes down; twice the area on the left of it is 512 x (2 x 256). Its right side is at x = 768
    // and goes up; twice the area on the left of it is 512 x (2 x 768).
    const Parts parts = split_parts({{256, 256}, {768, 256}, {768, 768}, {256, 768}}, {}, 1);
    ASSERT_EQ(parts.size(), 1U);
    EXPECT_EQ(parts.at({0, 0}).first, 0);
    EXPECT_EQ(parts.at({0, 0}).second, 512 * 1536 - 512 * 512);
}

TEST(ArcSplitter, SplitsADiagonalAtTheBordersOfPixels) {
    // The triangle goes up from (0, 0) to (2, 2) pixels and down at x = 0. It contains half of two
    // pixels and the whole of one.
    const Parts parts = split_parts({{0, 0}, {2048, 2048}, {0, 2048}}, {}, 2);
    EXPECT_EQ(parts.at({0, 0}), (std::pair<int, std::int64_t>{0, 1024 * 1024}));
    EXPECT_EQ(parts.at({1, 0}), (std::pair<int, std::int64_t>{-1024, 0}));
    EXPECT_EQ(parts.at({1, 1}), (std::pair<int, std::int64_t>{1024, 1024 * 1024}));
}

// The arc rises by 50 for every 1024 to the left. It crosses borders of columns at y = 125, 175,
// 225 and 275.
TEST(ArcSplitter, FlatArcCrossesManyColumnsOfARow) {
    const Parts parts = split_parts(edge({4608, 100}, {512, 300}), {}, 1);
    ASSERT_EQ(parts.size(), 5U);
    EXPECT_EQ(parts.at({0, 4}).first, 25);
    EXPECT_EQ(parts.at({0, 3}).first, 50);
    EXPECT_EQ(parts.at({0, 2}).first, 50);
    EXPECT_EQ(parts.at({0, 1}).first, 50);
    EXPECT_EQ(parts.at({0, 0}).first, 25);
}

// The arc rises by 20 for every 1 to the left. It crosses x = 1024 at y = 76 x 20 = 1520, in row 1.
TEST(ArcSplitter, SteepArcCrossesManyRowsOfAColumn) {
    const Parts parts = split_parts(edge({1100, 0}, {900, 4000}), {}, 4);
    ASSERT_EQ(parts.size(), 5U);
    EXPECT_EQ(parts.at({0, 1}).first, 1024);
    EXPECT_EQ(parts.at({1, 1}).first, 1520 - 1024);
    EXPECT_EQ(parts.at({1, 0}).first, 2048 - 1520);
    EXPECT_EQ(parts.at({2, 0}).first, 1024);
    EXPECT_EQ(parts.at({3, 0}).first, 4000 - 3072);
}

// A border belongs to the pixel on its right. Both arcs end on the border between pixels 0 and 1:
// one arc comes from the left, the other one from the right.
TEST(ArcSplitter, ArcsMayEndOnBorders) {
    const Parts right = split_parts(edge({0, 0}, {1024, 1024}), {}, 1);
    const Parts left = split_parts(edge({2048, 0}, {1024, 1024}), {}, 1);
    EXPECT_EQ(right.at({0, 0}), (std::pair<int, std::int64_t>{1024, 1024 * 1024}));
    EXPECT_EQ(left.at({0, 1}), (std::pair<int, std::int64_t>{1024, 1024 * 1024}));
}

TEST(ArcSplitter, LeavesOutOtherRows) {
    const std::vector<SubpixelPoint> square{{100, -3000}, {900, -3000}, {900, 9000}, {100, 9000}};
    const Parts parts = split_parts(square, {}, 3);
    EXPECT_EQ(parts.size(), 3U);
    EXPECT_EQ(parts.at({2, 0}).second, 1024 * 1800 - 1024 * 200);
}

class ArcSplitterOfRandomChains : public ::testing::Test {
  protected:
    std::vector<SubpixelPoint> chain(int range) {
        std::uniform_int_distribution<std::int32_t> coordinate(-range, range);
        std::vector<SubpixelPoint> points(3 + random_() % 5);
        for (SubpixelPoint& point : points) {
            point = {coordinate(random_), coordinate(random_)};
        }
        return points;
    }

  private:
    std::mt19937 random_{7};
};

// Half of the rounds have long arcs, many of which cross several columns within a row. The others
// have short arcs.
TEST_F(ArcSplitterOfRandomChains, ArcsSplitTogetherAreSplitAsOneByOne) {
    const auto list = [](std::span<const ArcSplitter::Part> parts) {
        std::vector<std::array<std::int32_t, 4>> numbers;
        for (const ArcSplitter::Part& part : parts) {
            numbers.push_back({part.row, part.column, part.twice_area, part.twice_area_on_left});
        }
        return numbers;
    };
    for (int round = 0; round < 100; ++round) {
        ArcSplitter together(40);
        std::vector<MonotoneArc> arcs;
        while (arcs.size() < ArcSplitter::kMaxArcs) {
            const std::vector<SubpixelPoint> ends = chain(round % 2 == 0 ? 40000 : 3000);
            const MonotoneArc arc{
                ends[0], {ends[1].x, ends[0].y + 1 + std::abs(ends[1].y)}, 0.1, {}};
            if (together.is_in_rows(arc, {})) {
                together.add(arc, {});
                arcs.push_back(arc);
            }
        }
        together.split();
        ArcSplitter alone(40);
        for (std::size_t k = 0; k < arcs.size(); ++k) {
            alone.clear();
            alone.add(arcs[k], {});
            alone.split();
            ASSERT_EQ(list(together.parts(k)), list(alone.parts(0)));
        }
    }
}

TEST_F(ArcSplitterOfRandomChains, MovesWithWholePixels) {
    for (int k = 0; k < 500; ++k) {
        const std::vector<SubpixelPoint> points = chain(5000);
        const Parts original = split_parts(points, {7 * kSubpixel, 5 * kSubpixel}, 50);
        const Parts moved = split_parts(points, {-90 * kSubpixel, 11 * kSubpixel}, 50);
        EXPECT_EQ(original.size(), moved.size());
        for (const auto& [pixel, part] : original) {
            EXPECT_EQ(part, moved.at({pixel.first + 6, pixel.second - 97}));
        }
    }
}

TEST_F(ArcSplitterOfRandomChains, BentArcsMoveWithWholePixels) {
    for (int k = 0; k < 500; ++k) {
        const std::vector<SubpixelPoint> points = chain(5000);
        if (points[0].y >= points[1].y) {
            continue;
        }
        const MonotoneArc arc{points[0], points[1], 0.7 * std::sin(k), {}};
        const Parts original = split_parts(arc, {7 * kSubpixel, 5 * kSubpixel}, 50);
        const Parts moved = split_parts(arc, {-90 * kSubpixel, 11 * kSubpixel}, 50);
        EXPECT_EQ(original.size(), moved.size());
        for (const auto& [pixel, part] : original) {
            EXPECT_EQ(part, moved.at({pixel.first + 6, pixel.second - 97}));
        }
    }
}

// The arc is a quarter of a circle of radius r around the origin. The part of a pixel within the
// circle is compared with the mean over 400 lines, whose error is 1e-5 pixel. Rounding to subpixels
// changes the part by up to half a subpixel.
TEST(ArcSplitter, OfACircleHasItsAreaInEveryPixel) {
    constexpr int kLines = 400;
    for (const int radius : {1024, 1500, 4000, 30000}) {
        const double sine = std::sin(0.125 * 2.0 * std::numbers::pi);
        const Parts parts = split_parts(MonotoneArc{{radius, 0}, {0, radius}, sine, {}}, {}, 40);
        for (const auto& [pixel, part] : parts) {
            double area = 0.0;
            for (int k = 0; k < kLines; ++k) {
                const double y = pixel.first + (k + 0.5) / kLines;
                const double r = static_cast<double>(radius) / kSubpixel;
                const double x = std::sqrt(std::max(0.0, r * r - y * y));
                area += y < r ? std::clamp(x - pixel.second, 0.0, 1.0) / kLines : 0.0;
            }
            // The pixel is on the left of all parts in columns further right. Each of them adds the
            // area of its height times the width of the pixel.
            double own = static_cast<double>(part.second);
            for (const auto& [other, right] : parts) {
                const bool is_right = other.first == pixel.first && other.second > pixel.second;
                own += is_right ? 2.0 * kSubpixel * right.first : 0.0;
            }
            EXPECT_NEAR(0.5 * own / (kSubpixel * kSubpixel), area, 2e-3)
                << radius << " " << pixel.first << " " << pixel.second;
        }
    }
}

TEST_F(ArcSplitterOfRandomChains, HeightsCancelInEveryRow) {
    for (int k = 0; k < 500; ++k) {
        std::map<int, int> heights;
        for (const auto& [pixel, part] : split_parts(chain(20000), {}, 20)) {
            heights[pixel.first] += part.first;
        }
        for (const auto& [row, height] : heights) {
            EXPECT_EQ(height, 0) << row;
        }
    }
}

}  // namespace
}  // namespace foam::texgen
