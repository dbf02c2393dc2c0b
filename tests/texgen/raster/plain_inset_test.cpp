#include "texgen/raster/plain_inset.h"

#include "core/foam/honeycomb.h"
#include "tests/support/raster_frames.h"
#include "texgen/raster/inset.h"

#include <gtest/gtest.h>

#include <array>

namespace foam::texgen {
namespace {

std::vector<SideArc> sides_of(const Frame& frame, BubbleId bubble) {
    std::vector<SideArc> sides;
    Vec2 at = Vec2::Zero();
    for (const HalfEdgeId h : frame.network.around(bubble)) {
        sides.push_back(place(pixel_arc(frame.arc(h)), at));
        at += frame.arc(h).chord;
    }
    return sides;
}

struct Tally {
    int bubbles = 0;
    int plain = 0;
};

// What is certain has to be what the exact way finds, to the bit. Foam units.
Tally compare(const Foam& foam, double distance) {
    const Frame frame = snapshot(foam, 1);
    Tally tally;
    PlainInset plain;
    InsetTracer tracer;
    for (const BubbleId bubble : frame.network.bubbles()) {
        const std::vector<SideArc> sides = sides_of(frame, bubble);
        ++tally.bubbles;
        ArcLoops found;
        if (!plain.trace(sides, distance, found)) {
            EXPECT_TRUE(found.arcs.empty());
            continue;
        }
        ++tally.plain;
        const ArcLoops& exact = tracer.trace(sides, std::array{sides.size()}, distance);
        EXPECT_EQ(found.loop_ends, exact.loop_ends);
        EXPECT_EQ(exact.open_ends, 0);
        EXPECT_EQ(found.arcs.size(), exact.arcs.size());
        for (std::size_t k = 0; k < std::min(found.arcs.size(), exact.arcs.size()); ++k) {
            EXPECT_EQ(found.arcs[k].tail, exact.arcs[k].tail);
            EXPECT_EQ(found.arcs[k].arc.chord, exact.arcs[k].arc.chord);
            EXPECT_EQ(found.arcs[k].arc.cosine, exact.arcs[k].arc.cosine);
            EXPECT_EQ(found.arcs[k].arc.sine, exact.arcs[k].arc.sine);
        }
    }
    return tally;
}

TEST(PlainInset, IsThatOfTheExactWay) {
    for (const std::uint64_t seed : {1U, 2U, 3U, 4U, 5U}) {
        for (const double distance : {0.01, 0.04, 0.1, 0.2, 0.35}) {
            compare(test::bent_foam(200, 0.3, seed), distance);
            compare(test::bent_foam(60, 1.5, seed), distance);
            compare(test::polydisperse_foam(60, seed), distance);
        }
    }
}

// Films of 2 pixels at 2048 x 2048 with 10,000 bubbles are 0.1 wide.
TEST(PlainInset, HoldsForMostBubbles) {
    const Tally tally = compare(test::bent_foam(500, 0.3, 9), 0.05);
    EXPECT_GT(tally.plain, 0.8 * tally.bubbles);
}

TEST(PlainInset, IsNotCertainOfWhatDropsOut) {
    EXPECT_EQ(compare(honeycomb(3, 4), 0.4).plain, 12);
    EXPECT_EQ(compare(honeycomb(3, 4), 0.6).plain, 0);  // all film: the apothem is 0.537
    Foam lens = honeycomb(2, 2);
    test::insert_lens(lens, id_at<FilmId>(1), 0.6);
    EXPECT_LT(compare(lens, 0.01).plain, compare(lens, 0.01).bubbles);
}

}  // namespace
}  // namespace foam::texgen
