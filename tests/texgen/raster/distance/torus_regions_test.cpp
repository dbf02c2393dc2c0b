// SPDX-License-Identifier: Apache-2.0

#include "texgen/raster/distance/torus_regions.h"

#include "core/dynamics/shear.h"
#include "tests/support/sample_foams.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <span>
#include <vector>

namespace foam::texgen {
namespace {

constexpr int kSide = 300;  // pixels

Vec2 real(SubpixelPoint point) {
    return Vec2(point.x, point.y);
}

// Expects that the sides of a region are those of its bubble in the network.
void expect_traced(const Region& region, const Frame& frame, const PixelFrame& pixels) {
    const Network& network = frame.network;
    const std::vector<HalfEdgeId> around = network.around(id_at<BubbleId>(region.id));
    const std::span<const DistanceArc> arcs = region.boundary.films();
    ASSERT_EQ(arcs.size(), around.size());
    LatticeOffset unwrapping;
    Vec2 tail = pixels.exact_position(network.tail(around.front()));
    EXPECT_EQ(region.first, pixels.rounded_position(network.tail(around.front())));
    for (std::size_t k = 0; k < around.size(); ++k) {
        const OutlineArc& edge = region.boundary.outline()[k];
        const FilmArc film = frame.arc(around[k]);
        const PixelArc expected = pixel_arc({pixels.scale * film.chord, film.half_angle});
        EXPECT_EQ(arcs[k].shape.chord, expected.chord);
        EXPECT_LT((arcs[k].tail - tail).norm(), 1e-9);
        EXPECT_NEAR(edge.cosine, expected.cosine, 1e-14);
        EXPECT_NEAR(edge.sine, expected.sine, 1e-14);
        EXPECT_EQ(edge.from,
                  real(pixels.rounded_position(network.tail(around[k])) +
                       pixels.translation(unwrapping)));
        unwrapping = unwrapping + network.offset(around[k]);
        tail += expected.chord;
        const HalfEdgeId next = around[(k + 1) % around.size()];
        const LatticeOffset at = k + 1 < around.size() ? unwrapping : LatticeOffset{};
        EXPECT_EQ(edge.to,
                  real(pixels.rounded_position(network.tail(next)) + pixels.translation(at)));
        EXPECT_LE(region.lowest.x, edge.from.x());
        EXPECT_GE(region.highest.y, edge.from.y());
    }
}

// Compares the regions with the network. Each side begins where the preceding side ends and has the
// shape of its film. The last side ends where the first side begins.
TEST(TorusRegions, TraceEveryBubbleOnce) {
    Foam foam = test::polydisperse_foam(120, 4);
    shear(foam, 0.3);
    const Frame frame = test::fitted_frame(foam, kSide, kSide);
    const RasterGrid grid{kSide, kSide, 40, 200};
    const TorusRegions regions(frame, grid, 2);
    const PixelFrame pixels(frame, grid);
    const Network& network = frame.network;
    std::vector<int> times(network.bubble_slots());
    Region traced;
    for (const TorusRegions::Start& start : regions.starts(0, 320)) {
        regions.trace(start, traced);
        EXPECT_EQ(traced.id, start.bubble);
        ++times[traced.id];
        expect_traced(traced, frame, pixels);
    }
    EXPECT_EQ(times, std::vector<int>(times.size(), 1));
}

TEST(TorusRegions, HaveAnOrderThatThreadsDoNotChange) {
    const Frame frame = snapshot(test::bent_foam(5000, 0.3, 6), 1);  // several tasks
    const TorusRegions one(frame, {kSide, kSide}, 1);
    const TorusRegions three(frame, {kSide, kSide}, 3);
    ASSERT_EQ(one.starts(0, 320).size(), 5000U);
    for (std::size_t k = 0; k < 5000; ++k) {
        EXPECT_EQ(one.starts(0, 320)[k].bubble, three.starts(0, 320)[k].bubble);
    }
}

}  // namespace
}  // namespace foam::texgen
