#include "texgen/raster/clip.h"

#include "core/foam/random.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace foam::texgen {
namespace {

double area(const std::vector<Vec2>& chain) {
    double twice = 0.0;
    for (std::size_t k = 0; k < chain.size(); ++k) {
        twice += cross(chain[k], chain[(k + 1) % chain.size()]);
    }
    return 0.5 * twice;
}

TEST(Clip, LeavesWhatLiesWithinAsItIs) {
    const std::vector<Vec2> chain{{0.0, 0.0}, {4.0, 1.0}, {1.0, 3.0}};
    std::vector<Vec2> clipped = chain;
    clip_to_box(clipped, {0.0, 0.0}, {4.0, 3.0});
    EXPECT_EQ(clipped, chain);
}

// A diamond |x| + |y| <= 3, area 18, without its four corners beyond 2, of area 1 each.
TEST(Clip, CutsCornersOff) {
    std::vector<Vec2> chain{{3.0, 0.0}, {0.0, 3.0}, {-3.0, 0.0}, {0.0, -3.0}};
    clip_to_box(chain, {-2.0, -2.0}, {2.0, 2.0});
    EXPECT_NEAR(area(chain), 14.0, 1e-14);
}

TEST(Clip, KeepsTheBoxWithinAChainAndNothingOutsideOfIt) {
    std::vector<Vec2> around{{-9.0, -9.0}, {9.0, -9.0}, {9.0, 9.0}, {-9.0, 9.0}};
    clip_to_box(around, {-2.0, -1.0}, {2.0, 1.0});
    EXPECT_NEAR(area(around), 8.0, 1e-14);
    std::reverse(around.begin(), around.end());
    EXPECT_NEAR(area(around), -8.0, 1e-14);
    std::vector<Vec2> beside{{3.0, 0.0}, {4.0, 0.0}, {4.0, 1.0}};
    clip_to_box(beside, {-2.0, -1.0}, {2.0, 1.0});
    EXPECT_TRUE(beside.empty());
}

// Walked the other way, the same points in the other order.
TEST(Clip, CutsAnEdgeAlikeInBothDirections) {
    Random random(3);
    for (int k = 0; k < 200; ++k) {
        std::vector<Vec2> there;
        for (int corner = 0; corner < 3; ++corner) {
            there.emplace_back(10.0 * random.uniform() - 5.0, 10.0 * random.uniform() - 5.0);
        }
        std::vector<Vec2> back(there.rbegin(), there.rend());
        clip_to_box(there, {-2.0, -2.0}, {2.0, 2.0});
        clip_to_box(back, {-2.0, -2.0}, {2.0, 2.0});
        ASSERT_EQ(there.size(), back.size());
        for (const Vec2& point : there) {
            EXPECT_NE(std::find(back.begin(), back.end(), point), back.end());
        }
    }
}

}  // namespace
}  // namespace foam::texgen
