#include "texgen/raster/outline/inset.h"

#include "tests/support/sample_foams.h"
#include "tests/support/simd_levels.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace foam::texgen {
namespace {

struct Side {
    PixelArc arc;
    Vec2 tail{0.0, 0.0};
};
using Sides = std::vector<Side>;

Sides polygon(const std::vector<Vec2>& corners) {
    Sides sides;
    for (std::size_t k = 0; k < corners.size(); ++k) {
        const Vec2 chord = corners[(k + 1) % corners.size()] - corners[k];
        sides.push_back({pixel_arc({chord, 0.0}), corners[k]});
    }
    return sides;
}

void add_loop(const Sides& sides, InsetTracer& tracer) {
    for (const Side& side : sides) {
        tracer.add_side(side.arc, side.tail);
    }
    tracer.end_loop();
}

double loop_area(const ArcLoops& loops, std::size_t begin, std::size_t end) {
    double area = 0.0;
    for (std::size_t k = begin; k < end; ++k) {
        const ArcLoops::Side& arc = loops.sides[k];
        area += 0.5 * cross(arc.tail, arc.tail + arc.arc.chord) + segment_area(film_arc(arc.arc));
    }
    return area;
}

// Area of each part that is left.
std::vector<double> inset_areas(const Sides& sides, double distance) {
    InsetTracer tracer;
    add_loop(sides, tracer);
    const ArcLoops& loops = tracer.trace(distance);
    EXPECT_EQ(loops.open_ends, 0);
    std::vector<double> areas;
    std::size_t begin = 0;
    for (const std::size_t end : loops.loop_ends) {
        areas.push_back(loop_area(loops, begin, end));
        begin = end;
    }
    return areas;
}

TEST(Inset, OfARectangleIsARectangle) {
    const auto sides = polygon({{0.0, 0.0}, {10.0, 0.0}, {10.0, 3.0}, {0.0, 3.0}});
    const std::vector<double> areas = inset_areas(sides, 1.0);
    ASSERT_EQ(areas.size(), 1U);
    EXPECT_NEAR(areas[0], 8.0, 1e-12);
}

TEST(Inset, OfWhatIsAllFilmIsEmpty) {
    const auto sides = polygon({{0.0, 0.0}, {10.0, 0.0}, {10.0, 3.0}, {0.0, 3.0}});
    EXPECT_TRUE(inset_areas(sides, 1.6).empty());
    EXPECT_TRUE(inset_areas(sides, 50.0).empty());
}

TEST(Inset, OfARegularHexagon) {
    // Side 1, apothem sqrt(3)/2; area is 2 sqrt(3) apothem squared.
    std::vector<Vec2> corners;
    for (int k = 0; k < 6; ++k) {
        const double angle = k * std::numbers::pi / 3.0;
        corners.emplace_back(std::cos(angle), std::sin(angle));
    }
    const double apothem = 0.5 * std::numbers::sqrt3 - 0.2;
    const std::vector<double> areas = inset_areas(polygon(corners), 0.2);
    ASSERT_EQ(areas.size(), 1U);
    EXPECT_NEAR(areas[0], 2.0 * std::numbers::sqrt3 * apothem * apothem, 1e-12);
}

TEST(Inset, DropsASideThatIsTooShort) {
    // A square with one corner cut off along x + y = 19. At distance h, the cut's offset
    // x + y = 19 - h sqrt(2) passes the corner (10 - h, 10 - h) of the others at h = 1 / (2 -
    // sqrt(2)).
    const auto sides = polygon({{0.0, 0.0}, {10.0, 0.0}, {10.0, 9.0}, {9.0, 10.0}, {0.0, 10.0}});
    const double leg = std::numbers::sqrt2 - 1.0;  // 9 + 9 - (19 - sqrt(2))
    EXPECT_NEAR(inset_areas(sides, 1.0).at(0), 64.0 - 0.5 * leg * leg, 1e-12);
    EXPECT_NEAR(inset_areas(sides, 2.0).at(0), 36.0, 1e-12);
}

TEST(Inset, OfATwoSidedBubble) {
    // Two arcs of half angle 60 degrees; their centres are as far apart as the radius r. The inset
    // is the lens of two circles of radius r - h around the same centres.
    const double chord = 10.0;
    const double half_angle = std::numbers::pi / 3.0;
    const Sides sides{{pixel_arc({Vec2(chord, 0.0), half_angle}), {0.0, 0.0}},
                      {pixel_arc({Vec2(-chord, 0.0), half_angle}), {chord, 0.0}}};
    const double r = 0.5 * chord / std::sin(half_angle);
    const double small = r - 1.0;
    const double lens = 2.0 * small * small * std::acos(0.5 * r / small) -
                        0.5 * r * std::sqrt(4.0 * small * small - r * r);
    const std::vector<double> areas = inset_areas(sides, 1.0);
    ASSERT_EQ(areas.size(), 1U);
    EXPECT_NEAR(areas[0], lens, 1e-12);
    EXPECT_TRUE(inset_areas(sides, 0.51 * r).empty());  // its middle is r / 2 from either side
    EXPECT_TRUE(inset_areas(sides, 2.0 * r).empty());
}

TEST(Inset, FallsIntoPartsAndRoundsCornersThatTurnBack) {
    // Two 10 x 10 squares, joined by a corridor of width 2 and length 4; distance 1.5 closes it.
    // Each part is a 7 x 7 square and a bulge towards the corridor, between circles around its two
    // corners: 2 times the integral of 1.5 - sqrt(2.25 - t²) over t from 0 to 1.
    const auto sides = polygon({{0.0, 0.0},
                                {10.0, 0.0},
                                {10.0, 4.0},
                                {14.0, 4.0},
                                {14.0, 0.0},
                                {24.0, 0.0},
                                {24.0, 10.0},
                                {14.0, 10.0},
                                {14.0, 6.0},
                                {10.0, 6.0},
                                {10.0, 10.0},
                                {0.0, 10.0}});
    const double bulge = 3.0 - (std::sqrt(1.25) + 2.25 * std::asin(1.0 / 1.5));
    const std::vector<double> areas = inset_areas(sides, 1.5);
    ASSERT_EQ(areas.size(), 2U);
    EXPECT_NEAR(areas[0], 49.0 + bulge, 1e-12);
    EXPECT_NEAR(areas[1], 49.0 + bulge, 1e-12);
}

TEST(Inset, OfACircleInThreeArcs) {
    // Corners that do not turn at all: the offsets touch there instead of crossing.
    Sides sides;
    for (int k = 0; k < 3; ++k) {
        const double a = 2.0 * std::numbers::pi / 3.0 * k + 0.1;
        const double b = a + 2.0 * std::numbers::pi / 3.0;
        const Vec2 from(7.0 * std::cos(a), 7.0 * std::sin(a));
        const Vec2 to(7.0 * std::cos(b), 7.0 * std::sin(b));
        sides.push_back({pixel_arc({to - from, std::numbers::pi / 3.0}), from});
    }
    const std::vector<double> areas = inset_areas(sides, 2.0);
    ASSERT_EQ(areas.size(), 1U);
    EXPECT_NEAR(areas[0], 25.0 * std::numbers::pi, 1e-6);
}

TEST(Inset, OfATinyBubbleNearAHugeWidth) {
    const auto sides = polygon({{0.0, 0.0}, {1e-3, 0.0}, {0.0, 1e-3}});
    EXPECT_TRUE(inset_areas(sides, 100.0).empty());
}

// Returns the sides of a bubble, in foam units.
Sides sides_of(const Frame& frame, BubbleId bubble) {
    Sides sides;
    Vec2 tail = Vec2::Zero();
    for (const HalfEdgeId h : frame.network.around(bubble)) {
        sides.push_back({pixel_arc(frame.arc(h)), tail});
        tail += sides.back().arc.chord;
    }
    return sides;
}

void expect_same(const ArcLoops::Side& a, const ArcLoops::Side& b) {
    EXPECT_EQ(a.tail, b.tail);
    EXPECT_EQ(a.arc.chord, b.arc.chord);
    EXPECT_EQ(a.arc.cosine, b.arc.cosine);
    EXPECT_EQ(a.arc.sine, b.arc.sine);
}

// Compares each bubble with the same one beside a far triangle that is all film: with two loops,
// all offsets are cut at all crossings. Returns the number of bubbles of which every side shows.
int compare_with_all_cuts(const Foam& foam, double distance) {
    const Frame frame = snapshot(foam, 1);
    int whole = 0;
    for (const BubbleId bubble : frame.network.bubbles()) {
        const Sides sides = sides_of(frame, bubble);
        InsetTracer alone;
        add_loop(sides, alone);
        const ArcLoops& found = alone.trace(distance);
        InsetTracer beside;
        add_loop(sides, beside);
        add_loop(polygon({{1e3, 0.0}, {1e3 + 1e-3, 0.0}, {1e3, 1e-3}}), beside);
        const ArcLoops& expected = beside.trace(distance);
        EXPECT_EQ(found.loop_ends, expected.loop_ends);
        EXPECT_EQ(found.open_ends, expected.open_ends);
        EXPECT_EQ(found.sides.size(), expected.sides.size());
        for (std::size_t k = 0; k < found.sides.size(); ++k) {
            expect_same(found.sides[k], expected.sides[k]);
        }
        whole += found.sides.size() == sides.size() ? 1 : 0;
    }
    return whole;
}

TEST(Inset, IsTheSameWhetherOrNotAllCutsAreTried) {
    at_every_simd_level([] {
        for (const std::uint64_t seed : {1U, 2U, 3U}) {
            for (const double distance : {0.01, 0.04, 0.1, 0.2, 0.35}) {
                compare_with_all_cuts(test::bent_foam(200, 0.3, seed), distance);
                compare_with_all_cuts(test::bent_foam(60, 1.5, seed), distance);
                compare_with_all_cuts(test::polydisperse_foam(60, seed), distance);
            }
        }
    });
    EXPECT_GT(compare_with_all_cuts(test::polydisperse_foam(300, 1), 0.05), 200);
}

TEST(Inset, LeavesOutSidesWithoutALength) {
    Sides sides = polygon({{0.0, 0.0}, {10.0, 0.0}, {10.0, 3.0}, {0.0, 3.0}});
    sides.insert(sides.begin() + 1, {pixel_arc({Vec2(0.0, 0.0), 0.1}), {10.0, 0.0}});
    EXPECT_NEAR(inset_areas(sides, 1.0).at(0), 8.0, 1e-12);
}

TEST(Inset, TracesOneLoopOfSeveral) {
    InsetTracer tracer;
    add_loop(polygon({{0.0, 0.0}, {4.0, 0.0}, {4.0, 4.0}, {0.0, 4.0}}), tracer);
    add_loop(polygon({{20.0, 0.0}, {30.0, 0.0}, {30.0, 3.0}, {20.0, 3.0}}), tracer);
    const ArcLoops& both = tracer.trace(1.0);
    EXPECT_EQ(both.loop_ends.size(), 2U);
    const ArcLoops& second = tracer.trace_loop(1, 1.0);
    ASSERT_EQ(second.loop_ends.size(), 1U);
    EXPECT_NEAR(loop_area(second, 0, second.sides.size()), 8.0, 1e-12);
}

}  // namespace
}  // namespace foam::texgen
