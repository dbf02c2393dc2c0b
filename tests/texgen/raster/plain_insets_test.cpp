#include "texgen/raster/plain_insets.h"

#include "core/foam/honeycomb.h"
#include "tests/support/raster_frames.h"
#include "texgen/raster/arcs/monotone.h"
#include "texgen/raster/inset.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <vector>

namespace foam::texgen {
namespace {

std::vector<PixelArc> shapes_of(const Frame& frame, BubbleId bubble) {
    std::vector<PixelArc> shapes;
    for (const HalfEdgeId h : frame.network.around(bubble)) {
        shapes.push_back(pixel_arc(frame.arc(h)));
    }
    return shapes;
}

std::vector<SideArc> sides_of(const std::vector<PixelArc>& shapes) {
    std::vector<SideArc> sides;
    Vec2 at = Vec2::Zero();
    for (const PixelArc& shape : shapes) {
        sides.push_back(place(shape, at));
        at += shape.chord;
    }
    return sides;
}

struct Tally {
    int bubbles = 0;
    int plain = 0;
    int with_every_side = 0;  // of those that are not certain

    friend bool operator==(const Tally& a, const Tally& b) = default;
};

// What is certain has to be what the exact way finds, to the bit.
void compare_arcs(const PlainInsets& plain, std::size_t k, const ArcLoops& exact) {
    EXPECT_EQ(exact.loop_ends, std::vector{exact.arcs.size()});
    EXPECT_EQ(exact.open_ends, 0);
    ASSERT_EQ(plain.end(k) - plain.begin(k), exact.arcs.size());
    for (std::size_t n = 0; n <= exact.arcs.size(); ++n) {
        const ArcLoops::Arc& expected = exact.arcs[n % exact.arcs.size()];
        const std::size_t lane = plain.begin(k) + n;
        EXPECT_EQ(plain.arc(lane).tail, expected.tail);
        EXPECT_EQ(plain.rounded_tail(lane), to_subpixel(expected.tail));
        if (n < exact.arcs.size()) {
            const PixelArc& arc = expected.arc;
            EXPECT_EQ(plain.arc(lane).arc.chord, arc.chord);
            EXPECT_EQ(plain.arc(lane).arc.cosine, arc.cosine);
            EXPECT_EQ(plain.arc(lane).arc.sine, arc.sine);
            EXPECT_EQ(plain.sine(lane), arc.sine);
            EXPECT_EQ(plain.is_monotone(lane), MonotonePieces(arc).pieces().size() == 1);
        }
    }
}

// Foam units.
Tally compare(const Foam& foam, double distance, std::size_t at_once) {
    const Frame frame = snapshot(foam, 1);
    Tally tally;
    PlainInsets plain;
    InsetTracer tracer;
    std::vector<std::vector<SideArc>> sides;
    const auto compare_some = [&] {
        plain.trace(distance);
        for (std::size_t k = 0; k < sides.size(); ++k) {
            const ArcLoops& exact = tracer.trace(sides[k], distance);
            ++tally.bubbles;
            if (plain.is_certain(k)) {
                ++tally.plain;
                compare_arcs(plain, k, exact);
            } else if (exact.arcs.size() == sides[k].size() && exact.loop_ends.size() == 1) {
                ++tally.with_every_side;
            }
        }
        plain.clear();
        sides.clear();
    };
    for (const BubbleId bubble : frame.network.bubbles()) {
        const std::vector<PixelArc> shapes = shapes_of(frame, bubble);
        if (shapes.size() <= PlainInsets::kMostSides) {
            plain.add(shapes.size(), [&](std::size_t k) { return shapes[k]; });
            sides.push_back(sides_of(shapes));
        }
        if (sides.size() == at_once) {
            compare_some();
        }
    }
    compare_some();
    return tally;
}

Tally compare(const Foam& foam, double distance) {
    const Tally tally = compare(foam, distance, PlainInsets::kMostBubbles);
    EXPECT_EQ(compare(foam, distance, 1), tally);
    return tally;
}

TEST(PlainInsets, IsThatOfTheExactWay) {
    for (const std::uint64_t seed : {1U, 2U, 3U, 4U, 5U}) {
        for (const double distance : {0.01, 0.04, 0.1, 0.2, 0.35}) {
            compare(test::bent_foam(200, 0.3, seed), distance);
            compare(test::bent_foam(60, 1.5, seed), distance);
            compare(test::polydisperse_foam(60, seed), distance);
        }
    }
}

// Films of 2 pixels at 2048 x 2048 with 10,000 bubbles are 0.1 wide.
TEST(PlainInsets, HoldsForMostBubbles) {
    const Tally tally = compare(test::bent_foam(500, 0.3, 9), 0.05);
    EXPECT_GT(tally.plain, 0.8 * tally.bubbles);
    const Tally settled = compare(test::polydisperse_foam(300, 1), 0.05);
    EXPECT_LT(tally.with_every_side, 0.03 * tally.bubbles);
    EXPECT_EQ(settled.with_every_side, 0);
}

TEST(PlainInsets, IsNotCertainOfWhatDropsOut) {
    EXPECT_EQ(compare(honeycomb(3, 4), 0.4).plain, 12);
    EXPECT_EQ(compare(honeycomb(3, 4), 0.6).plain, 0);  // all film: the apothem is 0.537
    Foam lens = honeycomb(2, 2);
    test::insert_lens(lens, id_at<FilmId>(1), 0.6);
    EXPECT_LT(compare(lens, 0.01).plain, compare(lens, 0.01).bubbles);
}

// A rectangle of 10 x 3 whose lower side rises by 1.2 in its middle: tan(a / 2) = 1.2 / 5. At
// distance h that leaves 3 - 1.2 - 2 h between the offsets, which is not seen from their ends.
TEST(PlainInsets, LooksForCrossingsWhereSidesBend) {
    const double half_angle = -2.0 * std::atan(1.2 / 5.0);
    const std::array<PixelArc, 4> shapes{pixel_arc({Vec2(10.0, 0.0), half_angle}),
                                         pixel_arc({Vec2(0.0, 3.0), 0.0}),
                                         pixel_arc({Vec2(-10.0, 0.0), 0.0}),
                                         pixel_arc({Vec2(0.0, -3.0), 0.0})};
    PlainInsets plain;
    plain.add(shapes.size(), [&](std::size_t k) { return shapes[k]; });
    plain.trace(0.89);
    EXPECT_TRUE(plain.is_certain(0));
    plain.trace(0.91);
    EXPECT_FALSE(plain.is_certain(0));
}

// Those before and after it in the lanes are not touched by what is no number there.
TEST(PlainInsets, IsNotCertainWithASideOfNoLength) {
    std::vector<PixelArc> square;
    for (const Vec2& chord : {Vec2(4.0, 0.0), Vec2(0.0, 4.0), Vec2(-4.0, 0.0), Vec2(0.0, -4.0)}) {
        square.push_back({chord, 1.0, 0.0});
    }
    const auto side = [&](std::size_t k) { return square[k]; };
    const auto side_or_none = [&](std::size_t k) {
        return k < 4 ? square[k] : PixelArc{Vec2(0.0, 0.0), 1.0, 0.0};
    };
    PlainInsets plain;
    plain.add(4, side);
    plain.add(5, side_or_none);
    plain.add(4, side);
    plain.trace(1.0);
    EXPECT_TRUE(plain.is_certain(0));
    EXPECT_FALSE(plain.is_certain(1));
    EXPECT_TRUE(plain.is_certain(2));
    EXPECT_EQ(plain.rounded_tail(plain.begin(2)), (SubpixelPoint{kSubpixel, kSubpixel}));
    EXPECT_EQ(plain.rounded_tail(plain.end(2)), (SubpixelPoint{kSubpixel, kSubpixel}));
}

}  // namespace
}  // namespace foam::texgen
