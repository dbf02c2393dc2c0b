#include "texgen/raster/small_mask.h"

#include "tests/support/raster_masks.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <numbers>
#include <random>
#include <vector>

namespace foam::texgen {
namespace {

constexpr int kSide = 40;

// Around the middle of the mask, each side bent to and fro by up to a half angle.
std::vector<SnappedArc> bent_polygon(std::size_t sides, double bend, std::mt19937& random) {
    std::uniform_real_distribution<double> uniform(-1.0, 1.0);
    std::vector<SubpixelPoint> corners;
    for (std::size_t k = 0; k < sides; ++k) {
        const double turn = (static_cast<double>(k) + 0.4 * uniform(random)) /
                            static_cast<double>(sides) * 2.0 * std::numbers::pi;
        const double radius = 12.0 + 5.0 * uniform(random);
        corners.push_back(to_subpixel(
            Vec2(0.5 * kSide + radius * std::cos(turn), 0.5 * kSide + radius * std::sin(turn))));
    }
    std::vector<SnappedArc> arcs;
    for (std::size_t k = 0; k < sides; ++k) {
        const double half_angle = bend * uniform(random);
        arcs.push_back(
            {corners[k], corners[(k + 1) % sides], std::cos(half_angle), std::sin(half_angle)});
    }
    return arcs;
}

SideLanes lanes_of(const std::vector<SnappedArc>& arcs, SubpixelPoint translation) {
    SideLanes lanes{};
    for (std::size_t k = 0; k < SideLanes::kLanes; ++k) {
        const bool is_side = k < arcs.size();
        const SnappedArc arc = is_side ? arcs[k] : SnappedArc{arcs[0].tail, arcs[0].tail};
        const SubpixelPoint chord = arc.head - arc.tail;
        lanes.set(
            k, {Vec2(chord.x, chord.y) / kSubpixel, arc.cosine, arc.sine}, arc.tail - translation);
    }
    return lanes;
}

// Also of parts of it, and of what reaches beyond the columns.
TEST(SmallMask, HasThePixelsOfACellMask) {
    std::mt19937 random(7);
    const SubpixelPoint translation{-70000, 12345};
    SmallMask small;
    int filled = 0;
    for (int round = 0; round < 400; ++round) {
        const std::size_t sides = 2 + static_cast<std::size_t>(round) % 7;
        const std::vector<SnappedArc> arcs = bent_polygon(sides, 0.004 * round, random);
        for (const auto& [columns, begin, end] :
             {std::tuple{40, 0, 40}, {25, 0, 40}, {40, 13, 40}, {40, 5, 21}}) {
            if (!small.fill(lanes_of(arcs, translation), translation, columns, {begin, end})) {
                continue;
            }
            ++filled;
            const CellMask mask = test::mask_of(arcs, columns, end, begin);
            for (int row = begin; row < end; ++row) {
                ASSERT_EQ(small.row(row), mask.whole_row(row)) << round << ", " << row;
            }
        }
    }
    EXPECT_GT(filled, 1500);
}

// Ties of rounding, and sides along the middles of rows and columns.
TEST(SmallMask, HasThePixelsOfPolygonsOnMiddles) {
    constexpr std::int32_t kHalf = kSubpixel / 2;
    std::mt19937 random(3);
    std::uniform_int_distribution<int> whole(0, 20);
    SmallMask small;
    for (int round = 0; round < 200; ++round) {
        std::vector<SnappedArc> arcs(4);
        for (SnappedArc& arc : arcs) {
            arc.tail = {whole(random) * kHalf, whole(random) * kHalf};
        }
        for (std::size_t k = 0; k < arcs.size(); ++k) {
            arcs[k].head = arcs[(k + 1) % arcs.size()].tail;
        }
        ASSERT_TRUE(small.fill(lanes_of(arcs, {}), {}, kSide, {0, kSide}));
        const CellMask mask = test::mask_of(arcs, kSide, kSide);
        for (int row = 0; row < kSide; ++row) {
            ASSERT_EQ(small.row(row), mask.whole_row(row)) << round << ", " << row;
        }
    }
}

}  // namespace
}  // namespace foam::texgen
