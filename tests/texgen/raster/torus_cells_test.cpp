#include "texgen/raster/torus_cells.h"

#include "core/dynamics/shear.h"
#include "tests/support/sample_foams.h"
#include "texgen/raster/kept_cells.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <vector>

namespace foam::texgen {
namespace {

constexpr int kSide = 300;  // pixels, three bands

Frame sheared_frame() {
    Foam foam = test::polydisperse_foam(120, 4);  // some of more than eight sides
    shear(foam, 0.3);
    return test::fitted_frame(foam, kSide, kSide);
}

// The sides of a cell beside those of the network: each goes on where the one before it ends, by
// its film, and the last one ends where the first begins.
void expect_sides(const TorusCell& cell, const PixelFrame& pixels) {
    const Network& network = pixels.frame.network;
    const std::vector<HalfEdgeId> around = network.around(cell.bubble);
    ASSERT_EQ(cell.sides.count, around.size());
    LatticeOffset lift;
    for (std::size_t k = 0; k < around.size(); ++k) {
        const PixelArc expected = pixel_arc(pixels.arc(around[k]));
        const PixelArc arc = cell.sides.arc(k);
        EXPECT_EQ(arc.chord, expected.chord);
        EXPECT_NEAR(arc.cosine, expected.cosine, 1e-14);
        EXPECT_NEAR(arc.sine, expected.sine, 1e-14);
        const SubpixelPoint tail = cell.sides.tail(k);
        EXPECT_EQ(tail, pixels.junction(network.tail(around[k])) + pixels.translation(lift));
        EXPECT_LE(cell.extent.lowest.x, tail.x);
        EXPECT_GE(cell.extent.highest.x, tail.x);
        EXPECT_LE(cell.extent.lowest.y, tail.y);
        EXPECT_GE(cell.extent.highest.y, tail.y);
        lift = lift + network.offset(around[k]);
    }
    EXPECT_EQ(lift, LatticeOffset{});
    EXPECT_EQ(cell.extent.first, cell.sides.tail(0));
    EXPECT_EQ(cell.sides.first, pixels.exact(network.tail(around.front())));
    for (std::size_t k = around.size(); k % SideLanes::kLanes != 0; ++k) {
        EXPECT_EQ(cell.sides.arc(k).chord, Vec2(0.0, 0.0));
        EXPECT_EQ(cell.sides.tail(k), cell.sides.tail(0));
    }
}

TEST(TorusCells, GoAroundEveryBubbleOnceInItsBand) {
    const Frame frame = sheared_frame();
    const RasterGrid grid{kSide, kSide, 40, 200};
    const TorusCells cells(frame, grid, 2);
    ASSERT_EQ(cells.bands(), 3);
    CellGroup group;
    std::vector<int> times(frame.network.bubble_slots());
    std::size_t most_sides = 0;
    for (int band = 0; band < cells.bands(); ++band) {
        std::span<const TorusBubble> bubbles = cells.bubbles(band);
        for (std::size_t size = 1; !bubbles.empty(); bubbles = bubbles.subspan(size)) {
            group.begin(bubbles, cells.films());
            group.advance();
            size = group.cells().size();
            for (const TorusCell& cell : group.cells()) {
                expect_sides(cell, PixelFrame(frame, grid));
                const int row = pixel_of(cell.extent.first.y) % kSide;
                EXPECT_EQ(row / TorusCells::kBandRows, band);
                ++times[index_of(cell.bubble)];
                most_sides = std::max(most_sides, cell.sides.count);
            }
        }
    }
    EXPECT_EQ(times, std::vector<int>(times.size(), 1));
    EXPECT_GT(most_sides, SideLanes::kLanes);
}

TEST(TorusCells, HaveAnOrderThatThreadsDoNotChange) {
    const Frame frame = snapshot(test::bent_foam(5000, 0.3, 6), 1);  // several parts
    const TorusCells one(frame, {kSide, kSide}, 1);
    const TorusCells three(frame, {kSide, kSide}, 3);
    for (int band = 0; band < one.bands(); ++band) {
        const std::span<const TorusBubble> expected = one.bubbles(band);
        const std::span<const TorusBubble> found = three.bubbles(band);
        ASSERT_EQ(found.size(), expected.size());
        for (std::size_t k = 0; k < found.size(); ++k) {
            EXPECT_EQ(found[k].bubble, expected[k].bubble);
        }
    }
}

TEST(KeptCells, OutliveTheirGroup) {
    const Frame frame = sheared_frame();
    const RasterGrid grid{kSide, kSide};
    const TorusCells cells(frame, grid, 1);
    CellGroup group;
    KeptCells kept;
    std::size_t count = 0;
    for (int band = 0; band < cells.bands(); ++band) {
        group.begin(cells.bubbles(band), cells.films());
        for (const TorusCell& cell : group.cells()) {
            kept.add(cell);
            ++count;
        }
    }
    group.begin(cells.bubbles(0), cells.films());
    group.cells();
    kept.visit([&](const TorusCell& cell) {
        expect_sides(cell, PixelFrame(frame, grid));
        --count;
    });
    EXPECT_EQ(count, 0);
}

}  // namespace
}  // namespace foam::texgen
