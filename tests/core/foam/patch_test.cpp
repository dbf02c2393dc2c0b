// SPDX-License-Identifier: Apache-2.0

#include "core/foam/patch.h"

#include "core/equilibrium/equilibrate.h"
#include "core/foam/area_field.h"
#include "core/foam/measure.h"
#include "tests/core/foams.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <vector>

namespace foam {
namespace {

PatchOptions options_for(int bubbles, std::uint64_t seed) {
    PatchOptions options;
    options.bubbles = bubbles;
    options.seed = seed;
    return options;
}

std::vector<Outline> outlines() {
    return {disc_outline(),
            rectangle_outline(3.0),
            outline_from_wkt("POLYGON((0 0, 4 0, 4 4, 3 4, 3 1, 1 1, 1 4, 0 4))"),
            outline_from_wkt("POLYGON((0 0, 9 0, 9 9, 0 9), (3 3, 3 6, 6 6, 6 3))")};
}

TEST(SeedPatch, GivesAValidFoamOfMeanAreaOne) {
    for (const Outline& outline : outlines()) {
        for (const int bubbles : {20, 60, 200}) {
            for (std::uint64_t seed = 1; seed <= 5; ++seed) {
                const Foam foam = seed_patch(outline, options_for(bubbles, seed));
                ASSERT_TRUE(test::is_valid(foam.network)) << bubbles << ", seed " << seed;
                const auto count = static_cast<double>(foam.network.bubble_count());
                EXPECT_NEAR(count / bubbles, 1.0, 0.2);
                EXPECT_NEAR(test::total_target(foam) / count, 1.0, 1e-9);
            }
        }
    }
}

TEST(SeedPatch, LeavesNoSlivers) {
    for (const Outline& outline : outlines()) {
        const Foam foam = seed_patch(outline, options_for(200, 3));
        for (const BubbleId bubble : foam.network.bubbles()) {
            EXPECT_GT(foam.target_areas[bubble], 0.09);
        }
    }
}

TEST(SeedPatch, IsTheSameForTheSameSeed) {
    const Foam foam = seed_patch(disc_outline(), options_for(50, 2));
    EXPECT_TRUE(test::are_same(foam, seed_patch(disc_outline(), options_for(50, 2))));
    EXPECT_FALSE(test::are_same(foam, seed_patch(disc_outline(), options_for(50, 3))));
}

// In equilibrium, the energy of a patch is twice the sum of pressure times area (E3).
TEST(SeedPatch, FindsItsOwnFreeShape) {
    for (const Outline& outline : outlines()) {
        Foam foam = seed_patch(outline, options_for(60, 4));
        const EquilibriumSummary summary = equilibrate(foam, {});
        ASSERT_TRUE(summary.converged());
        EXPECT_TRUE(test::is_valid(foam.network));
        double work = energy(foam);
        for (const BubbleId bubble : foam.network.bubbles()) {
            work -= 2.0 * foam.pressures[bubble] * foam.target_areas[bubble];
        }
        for (const LoneBubble& bubble : foam.lone_bubbles) {
            work -= 2.0 * foam.film_tension / lone_radius(bubble) * bubble.target_area;
        }
        EXPECT_NEAR(work / energy(foam), 0.0, 1e-9);
    }
}

TEST(SeedPatch, LloydMakesAreasMoreEqual) {
    const auto spread = [](const PatchOptions& options) {
        const Foam foam = seed_patch(disc_outline(), options);
        double largest = 0.0;
        for (const BubbleId bubble : foam.network.bubbles()) {
            largest = std::max(largest, foam.target_areas[bubble]);
        }
        return largest;
    };
    PatchOptions relaxed = options_for(100, 1);
    relaxed.lloyd_iterations = 10;
    EXPECT_LT(spread(relaxed), 0.8 * spread(options_for(100, 1)));
}

TEST(SeedPatch, SpreadsAreasOverTheRatio) {
    PatchOptions options = options_for(50, 1);
    options.area_ratio = 20.0;
    const Foam foam = seed_patch(disc_outline(), options);
    double smallest = foam.target_areas[BubbleId{0}];
    double largest = smallest;
    for (const BubbleId bubble : foam.network.bubbles()) {
        smallest = std::min(smallest, foam.target_areas[bubble]);
        largest = std::max(largest, foam.target_areas[bubble]);
    }
    EXPECT_NEAR(largest / smallest, 20.0, 1e-9);
    EXPECT_NEAR(test::total_target(foam), static_cast<double>(foam.network.bubble_count()), 1e-9);
}

TEST(SeedPatch, RejectsOptionsOutOfRange) {
    EXPECT_THROW(seed_patch(disc_outline(), options_for(1, 1)), std::invalid_argument);
    PatchOptions options;
    options.area_ratio = 0.5;
    EXPECT_THROW(seed_patch(disc_outline(), options), std::invalid_argument);
    options = {};
    options.surface_tension = 0.0;
    EXPECT_THROW(seed_patch(disc_outline(), options), std::invalid_argument);
    EXPECT_THROW(seed_patch({{{0.0, 0.0}, {1.0, 0.0}, {2.0, 0.0}}, {}}, {}), std::invalid_argument);
}

// Two squares with the areas 9 and 1 and a triangle with the area 0.2, far apart from each other.
std::vector<Outline> three_parts() {
    return {outline_from_wkt("POLYGON((0 0, 3 0, 3 3, 0 3))"),
            outline_from_wkt("POLYGON((5 0, 6 0, 6 1, 5 1))"),
            outline_from_wkt("POLYGON((8 0, 9 0, 8 0.4))")};
}

// Of 51 bubbles, the area of 10.2 gives 5 to each unit of area: 45 to the large square, 5 to the
// small one, and 1 to the triangle, which is a lone bubble. Slivers are merged.
TEST(SeedPatch, GivesPartsBubblesByArea) {
    for (std::uint64_t seed = 1; seed <= 5; ++seed) {
        const Foam foam = seed_patch(three_parts(), options_for(51, seed));
        ASSERT_TRUE(test::is_valid(foam.network));
        ASSERT_EQ(foam.lone_bubbles.size(), 1U);
        int right = 0;  // bubbles of the small square
        for (const BubbleId bubble : foam.network.bubbles()) {
            const HalfEdgeId h = foam.network.first(bubble);
            right += foam.positions[foam.network.tail(h)].x() >
                             foam.lone_bubbles[0].center.x() - 4.3 * std::sqrt(5.0)
                         ? 1
                         : 0;
        }
        EXPECT_GE(right, 3);
        EXPECT_LE(right, 6);
        EXPECT_GT(foam.network.bubble_count(), 36U);
        const auto count = static_cast<double>(foam.network.bubble_count() + 1);
        EXPECT_NEAR(test::total_target(foam) + foam.lone_bubbles[0].target_area, count, 1e-9);
    }
}

// The triangle has its centroid at (8 1/3, 2/15), the large square at (1.5, 1.5).
TEST(SeedPatch, KeepsThePositionsOfParts) {
    const Foam foam = seed_patch(three_parts(), options_for(51, 1));
    double low = foam.lone_bubbles[0].center.x();
    for (const JunctionId junction : foam.network.junctions()) {
        low = std::min(low, foam.positions[junction].x());
    }
    const double scale = std::sqrt(foam.lone_bubbles[0].target_area / 0.2);
    EXPECT_NEAR((foam.lone_bubbles[0].center.x() - low) / scale, 8.0 + 1.0 / 3.0, 1e-9);
}

TEST(SeedPatch, BringsPartsToEquilibrium) {
    Foam foam = seed_patch(three_parts(), options_for(51, 1));
    EXPECT_TRUE(equilibrate(foam, {}).converged());
    EXPECT_TRUE(test::is_valid(foam.network));
}

// In the left half of the bounding box, from 0 to 4.5, bubbles are four times as large as in the
// right half: the large square has 9 / 4 of the density, the small one 1 and the triangle 0.2, so
// that of 69 bubbles the small square gets 20.
TEST(SeedPatch, GivesPartsBubblesByAnAreaField) {
    PatchOptions options = options_for(69, 1);
    options.areas = AreaField(2, 1, {4.0, 1.0});
    const Foam foam = seed_patch(three_parts(), options);
    ASSERT_TRUE(test::is_valid(foam.network));
    double smallest = 1e9;
    double largest = 0.0;
    int large = 0;
    for (const BubbleId bubble : foam.network.bubbles()) {
        smallest = std::min(smallest, foam.target_areas[bubble]);
        largest = std::max(largest, foam.target_areas[bubble]);
    }
    for (const BubbleId bubble : foam.network.bubbles()) {
        large += foam.target_areas[bubble] > 2.0 * smallest ? 1 : 0;
    }
    EXPECT_NEAR(largest / smallest, 4.0, 1e-9);
    EXPECT_NEAR(large, 45, 8);
}

// Three parts of one bubble each: the network has only the ghost.
TEST(SeedPatch, MayHaveOnlyLoneBubbles) {
    const std::vector<Outline> parts(3, rectangle_outline(1.0));
    Foam foam = seed_patch(parts, options_for(3, 1));
    EXPECT_EQ(foam.lone_bubbles.size(), 3U);
    EXPECT_EQ(foam.network.bubble_count(), 0U);
    EXPECT_TRUE(equilibrate(foam, {}).converged());
}

TEST(SeedPatch, SpreadsAreasOfLoneBubbles) {
    PatchOptions options = options_for(51, 1);
    options.area_ratio = 4.0;
    const Foam foam = seed_patch(three_parts(), options);
    EXPECT_GE(foam.lone_bubbles[0].target_area, 0.4);
    EXPECT_LE(foam.lone_bubbles[0].target_area, 2.5);
    const auto count = static_cast<double>(foam.network.bubble_count() + 1);
    EXPECT_NEAR(test::total_target(foam) + foam.lone_bubbles[0].target_area, count, 1e-9);
}

// The triangle has an area of 0.2 of 10.2: with 4 bubbles, that is 0.078 bubbles. A tenth of a
// bubble needs 5.1 bubbles.
TEST(SeedPatch, RejectsPartsThatAreTooSmall) {
    try {
        seed_patch(three_parts(), options_for(4, 1));
        FAIL();
    } catch (const std::runtime_error& error) {
        EXPECT_STREQ(
            error.what(),
            "a part of the outline, at 94 % of its width and 7 % of its height, is smaller "
            "than a tenth of a bubble; use at least 6 bubbles, or remove this part");
    }
}

// If the cuts of neighboring cells with the outline differed, no draw of so many bubbles would give
// a valid foam.
TEST(SeedPatch, GivesAValidFoamOfManyBubbles) {
    const Foam foam = seed_patch(disc_outline(), options_for(30000, 1));
    EXPECT_GT(foam.network.bubble_count(), 29000U);
    EXPECT_TRUE(test::is_valid(foam.network));
}

// Some of ten thousand sites are at the same point of the grid of the Voronoi diagram.
TEST(SeedPatch, RejectsAnOutlineThatIsTooNarrow) {
    const Outline row = outline_from_wkt("POLYGON((0 0, 1 0, 1 0.000000002, 0 0.000000002))");
    try {
        seed_patch(row, options_for(10000, 1));
        FAIL();
    } catch (const std::runtime_error& error) {
        EXPECT_STREQ(error.what(),
                     "no valid patch of 10000 bubbles fits into this outline: it is too narrow, or "
                     "has parts too small for a bubble; use more bubbles or a wider outline (two "
                     "random sites are at the same point of the grid; try another seed)");
    }
}

// A sliver along the diagonal of its bounding box: almost no random point is inside.
TEST(SeedPatch, RejectsAnOutlineThatFillsTooLittleOfItsBoundingBox) {
    const Outline sliver = outline_from_wkt("POLYGON((0 0, 1 1, 1 1.00000001))");
    try {
        seed_patch(sliver, options_for(3, 1));
        FAIL();
    } catch (const std::runtime_error& error) {
        EXPECT_STREQ(error.what(),
                     "no valid patch of 3 bubbles fits into this outline: it is too narrow, or has "
                     "parts too small for a bubble; use more bubbles or a wider outline (of 103000 "
                     "random points, only 0 are inside)");
    }
}

// A rectangle whose left half has bubbles of a ninth of the area of those on its right: nine of ten
// bubbles are on the left. Small bubbles are no slivers.
TEST(Patch, AFieldDecidesTheNumberOfBubblesAndTheirAreas) {
    PatchOptions options;
    options.bubbles = 300;
    options.lloyd_iterations = 3;
    options.areas = AreaField(2, 1, {1.0, 9.0});
    const Foam foam = seed_patch(rectangle_outline(2.0), options);
    EXPECT_TRUE(test::is_valid(foam.network));
    const std::size_t bubbles = foam.network.bubble_count();
    EXPECT_NEAR(static_cast<double>(bubbles), 300.0, 30.0);
    std::vector<double> targets(foam.target_areas.begin(),
                                foam.target_areas.begin() + static_cast<std::ptrdiff_t>(bubbles));
    std::ranges::sort(targets);
    EXPECT_NEAR(targets[bubbles / 10] * 9.0, targets[bubbles - 5], 0.5);
    const auto small = std::ranges::count_if(targets, [](double area) { return area < 1.5; });
    EXPECT_NEAR(static_cast<double>(small), 0.9 * static_cast<double>(bubbles), 15.0);
}

}  // namespace
}  // namespace foam
