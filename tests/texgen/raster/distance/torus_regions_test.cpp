#include "texgen/raster/distance/torus_regions.h"

#include "core/dynamics/shear.h"
#include "tests/support/sample_foams.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace foam::texgen {
namespace {

constexpr int kSide = 300;  // pixels

Vec2 real(SubpixelPoint point) {
    return Vec2(point.x, point.y);
}

// Against the network: each side begins where the one before it ends, has the shape of its film,
// and the last one ends where the first begins.
TEST(TorusRegions, TraceEveryBubbleOnce) {
    Foam foam = test::polydisperse_foam(120, 4);
    shear(foam, 0.3);
    const Frame frame = test::fitted_frame(foam, kSide, kSide);
    const RasterGrid grid{kSide, kSide, 40, 200};
    const TorusRegions regions(frame, grid, 2);
    const PixelFrame pixels(frame, grid);
    const Network& network = frame.network;
    const SubpixelPoint offset{-5000, 77};
    std::vector<int> times(network.bubble_slots());
    for (std::size_t k = 0; k < regions.regions().size(); ++k) {
        const Region& region = regions.regions()[k];
        ++times[region.id];
        Boundary boundary;
        regions.trace(k, offset, boundary);
        const std::vector<HalfEdgeId> around = network.around(id_at<BubbleId>(region.id));
        ASSERT_EQ(boundary.sides.size(), around.size());
        ASSERT_EQ(boundary.loop_ends, std::vector<std::size_t>{around.size()});
        LatticeOffset lift;
        Vec2 tail = pixels.exact(network.tail(around.front())) + real(offset) / kSubpixel;
        for (std::size_t side = 0; side < around.size(); ++side) {
            const DistanceArc& arc = boundary.sides[side];
            const FilmArc film = frame.arc(around[side]);
            const PixelArc expected = pixel_arc({pixels.scale * film.chord, film.half_angle});
            EXPECT_EQ(arc.shape.chord, expected.chord);
            EXPECT_NEAR(arc.shape.cosine, expected.cosine, 1e-14);
            EXPECT_NEAR(arc.shape.sine, expected.sine, 1e-14);
            EXPECT_LT((arc.tail - tail).norm(), 1e-9);
            EXPECT_LT((arc.from / kSubpixel - tail).norm(), 1.0 / kSubpixel);
            EXPECT_EQ(arc.from,
                      real(pixels.junction(network.tail(around[side])) + pixels.translation(lift) +
                           offset));
            EXPECT_EQ(arc.to, boundary.sides[(side + 1) % around.size()].from);
            EXPECT_LE(region.lowest.x + offset.x, arc.from.x());
            EXPECT_GE(region.highest.y + offset.y, arc.from.y());
            lift = lift + network.offset(around[side]);
            tail += expected.chord;
        }
        EXPECT_EQ(real(region.first + offset), boundary.sides.front().from);
    }
    EXPECT_EQ(times, std::vector<int>(times.size(), 1));
}

TEST(TorusRegions, HaveAnOrderThatThreadsDoNotChange) {
    const Frame frame = snapshot(test::bent_foam(5000, 0.3, 6), 1);  // several tasks
    const TorusRegions one(frame, {kSide, kSide}, 1);
    const TorusRegions three(frame, {kSide, kSide}, 3);
    ASSERT_EQ(one.regions().size(), 5000U);
    for (std::size_t k = 0; k < one.regions().size(); ++k) {
        EXPECT_EQ(one.regions()[k].id, three.regions()[k].id);
    }
}

}  // namespace
}  // namespace foam::texgen
