// SPDX-License-Identifier: Apache-2.0

#include "core/library/foam_records.h"

#include "core/foam/measure.h"
#include "tests/support/sample_foams.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace foam {
namespace {

TEST(FoamRecords, MatchTheValuesOfATorus) {
    const Foam foam = test::polydisperse_foam(30, 2);
    const foamtex::FoamRecords records = records_of(snapshot(foam, 1));
    ASSERT_EQ(records.bubbles.size(), 30U);
    ASSERT_EQ(records.films.size(), 90U);  // Euler
    ASSERT_EQ(records.junctions.size(), 60U);
    std::vector<std::int64_t> sides(30);
    std::vector<double> perimeters(30);
    double length = 0.0;
    for (const foamtex::Film& film : records.films) {
        for (const std::int64_t bubble : {film.left, film.right}) {
            ++sides[static_cast<std::size_t>(bubble)];
            perimeters[static_cast<std::size_t>(bubble)] += film.length;
        }
        length += film.length;
        const foamtex::Point& tail = records.junctions[static_cast<std::size_t>(film.tail)];
        EXPECT_EQ(film.x, tail.x);
        EXPECT_EQ(film.y, tail.y);
    }
    for (std::size_t k = 0; k < records.bubbles.size(); ++k) {
        EXPECT_EQ(records.bubbles[k].sides, sides[k]);
        EXPECT_NEAR(records.bubbles[k].perimeter, perimeters[k], 1e-12);
    }
    EXPECT_NEAR(foam.film_tension * length, energy(foam), 1e-12);
}

// A higher pressure on the left makes an arc that bulges to the right (Laplace-Young).
TEST(FoamRecords, PressuresMatchHalfAngles) {
    const Foam foam = test::polydisperse_foam(30, 3);
    const foamtex::FoamRecords records = records_of(snapshot(foam, 1));
    for (const foamtex::Film& film : records.films) {
        const double difference = records.bubbles[static_cast<std::size_t>(film.left)].pressure -
                                  records.bubbles[static_cast<std::size_t>(film.right)].pressure;
        const double chord = std::hypot(film.chord_x, film.chord_y);
        EXPECT_NEAR(
            difference * chord / (2.0 * foam.film_tension), std::sin(film.half_angle), 1e-12);
    }
}

TEST(FoamRecords, IncludeTheOutsideAndLoneBubblesOfAPatch) {
    const foamtex::FoamRecords patch = records_of(snapshot(test::patch_foam(12, 1), 1));
    int outer = 0;
    for (const foamtex::Film& film : patch.films) {
        outer += film.left == -1 || film.right == -1 ? 1 : 0;
    }
    EXPECT_GT(outer, 3);
    EXPECT_EQ(extent_of(kPlane), foamtex::Extent());

    const Foam circles = test::circles({{.identity = 7, .center = {1.0, 2.0}, .target_area = 3.0}});
    const foamtex::FoamRecords records = records_of(snapshot(circles, 1));
    ASSERT_EQ(records.bubbles.size(), 1U);
    const foamtex::Bubble& bubble = records.bubbles.front();
    EXPECT_EQ(bubble.identity, 7);
    EXPECT_EQ(bubble.sides, 0);
    EXPECT_EQ(bubble.x, 1.0);
    // A circle of area A has the perimeter 2 sqrt(pi A).
    EXPECT_NEAR(bubble.perimeter, 2.0 * std::sqrt(std::numbers::pi * 3.0), 1e-14);
    EXPECT_NEAR(bubble.pressure * std::sqrt(3.0 / std::numbers::pi), circles.film_tension, 1e-14);
}

}  // namespace
}  // namespace foam
