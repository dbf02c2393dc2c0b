#include "texgen/raster/edge_walk.h"

#include <gtest/gtest.h>

#include <map>
#include <random>
#include <utility>
#include <vector>

namespace foam::texgen {
namespace {

using Parts = std::map<std::pair<int, int>, std::pair<int, std::int64_t>>;

Parts walk(const std::vector<SubpixelPoint>& chain, SubpixelPoint translation, int rows) {
    Parts parts;
    const auto sink = [&](const PixelPart& part) {
        auto& [height, area] = parts[{part.row, part.column}];
        height += part.height;
        area += part.area;
    };
    EdgeWalk(rows, sink).walk(chain, translation);
    return parts;
}

TEST(EdgeWalk, SquareInTheMiddleOfAPixel) {
    // Half a pixel wide and high, counter-clockwise. Left side at x = 256, down: area 512 x (2 x
    // 256); right side at x = 768, up.
    const Parts parts = walk({{256, 256}, {768, 256}, {768, 768}, {256, 768}}, {}, 1);
    ASSERT_EQ(parts.size(), 1U);
    EXPECT_EQ(parts.at({0, 0}).first, 0);
    EXPECT_EQ(parts.at({0, 0}).second, 512 * 512 - 512 * 1536);
}

TEST(EdgeWalk, DiagonalAcrossFourPixels) {
    // Up from (0, 0) to (2, 2) pixels and down again at x = 0: half of two pixels, all of one.
    const Parts parts = walk({{0, 0}, {2048, 2048}, {0, 2048}}, {}, 2);
    EXPECT_EQ(parts.at({0, 0}), (std::pair<int, std::int64_t>{0, -1024 * 1024}));
    EXPECT_EQ(parts.at({1, 0}), (std::pair<int, std::int64_t>{1024, 0}));
    EXPECT_EQ(parts.at({1, 1}), (std::pair<int, std::int64_t>{-1024, -1024 * 1024}));
}

TEST(EdgeWalk, LeavesOutOtherRows) {
    const std::vector<SubpixelPoint> square{{100, -3000}, {900, -3000}, {900, 9000}, {100, 9000}};
    const Parts parts = walk(square, {}, 3);
    EXPECT_EQ(parts.size(), 3U);
    EXPECT_EQ(parts.at({2, 0}).second, 1024 * 200 - 1024 * 1800);
}

class EdgeWalkOfRandomChains : public ::testing::Test {
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

TEST_F(EdgeWalkOfRandomChains, BackwardsCancels) {
    for (int k = 0; k < 500; ++k) {
        const std::vector<SubpixelPoint> there = chain(k % 2 == 0 ? 3000 : 60000);
        const std::vector<SubpixelPoint> back(there.rbegin(), there.rend());
        const Parts forward = walk(there, {}, 20);
        Parts backward = walk(back, {}, 20);
        for (const auto& [pixel, part] : forward) {
            EXPECT_EQ(part.first, -backward[pixel].first);
            EXPECT_EQ(part.second, -backward[pixel].second);
        }
    }
}

TEST_F(EdgeWalkOfRandomChains, MovesWithWholePixels) {
    for (int k = 0; k < 500; ++k) {
        const std::vector<SubpixelPoint> points = chain(5000);
        const Parts here = walk(points, {7 * kSubpixel, 5 * kSubpixel}, 50);
        const Parts there = walk(points, {-90 * kSubpixel, 11 * kSubpixel}, 50);
        EXPECT_EQ(here.size(), there.size());
        for (const auto& [pixel, part] : here) {
            EXPECT_EQ(part, there.at({pixel.first + 6, pixel.second - 97}));
        }
    }
}

TEST_F(EdgeWalkOfRandomChains, HeightsCancelInEveryRow) {
    for (int k = 0; k < 500; ++k) {
        std::map<int, int> heights;
        for (const auto& [pixel, part] : walk(chain(20000), {}, 20)) {
            heights[pixel.first] += part.first;
        }
        for (const auto& [row, height] : heights) {
            EXPECT_EQ(height, 0) << row;
        }
    }
}

}  // namespace
}  // namespace foam::texgen
