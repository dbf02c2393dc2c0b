// SPDX-License-Identifier: Apache-2.0

#include "core/foam/measure.h"

#include "core/foam/honeycomb.h"
#include "tests/core/foams.h"
#include "tests/support/sample_foams.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>

namespace foam {
namespace {

using test::bent_foam;

constexpr double kPi = std::numbers::pi;
constexpr double kRoot3 = std::numbers::sqrt3;
constexpr double kRounding = 1e-14;  // rounding errors of coordinates up to about 10

constexpr double kSide = 0.62040323940139973;  // side of a hexagon of area 1: sqrt(2 / (3 sqrt(3)))

// Returns the pressure that gives the films of one hexagon of a honeycomb (T = 1) the given
// s = delta c / 2T.
double pressure_for(double s) {
    return 2.0 * s / kSide;
}

// A film adds to one bubble the area that it takes from the other bubble, so that segments cancel
// for any pressures. This includes arcs at the limit of their half angle (at the pressures 20 and
// 1000).
TEST(Measure, AreasAddUpToTheTorusForAnyPressures) {
    for (const double pressure : {0.0, 0.5, 3.0, 20.0, 1000.0}) {
        for (const int bubbles : {2, 3, 10, 200}) {
            const Foam foam = bent_foam(bubbles, pressure, 7);
            const Indexed<BubbleId, double> areas = bubble_areas(foam);
            const double total = std::accumulate(areas.begin(), areas.end(), 0.0);
            EXPECT_NEAR(total / foam.domain.area(), 1.0, 1e-13) << bubbles << ' ' << pressure;
        }
    }
}

// With s = 1/2 the six films are arcs of 60 degrees with the radius c. The area of each segment is
// (pi/6 - sqrt(3)/4) c².
TEST(Measure, BulgingAddsSegmentsToTheAreaOfAHexagon) {
    Foam foam = honeycomb(4, 4);
    foam.pressures[BubbleId{5}] = pressure_for(0.5);
    const double segment = (kPi / 6.0 - kRoot3 / 4.0) * kSide * kSide;
    EXPECT_NEAR(polygon_area(foam, BubbleId{5}), 1.0, kRounding);
    EXPECT_NEAR(bubble_area(foam, BubbleId{5}), 1.0 + 6.0 * segment, kRounding);
    EXPECT_NEAR(bubble_area(foam, BubbleId{6}), 1.0 - segment, kRounding);
}

// The half angles are 15 degrees. The angles inside the hexagon grow by 30 degrees, and the angles
// outside shrink by 15 degrees. The radius is c / (2 sin 15 degrees), with
// (2 sin 15 degrees)² = 2 - sqrt(3). Each segment is a sector of 30 degrees minus a triangle:
// radius² (pi/12 - 1/4).
TEST(Measure, BulgingCausesKnownErrorsOfAreaAndAngle) {
    Foam foam = honeycomb(4, 4);
    foam.pressures[BubbleId{5}] = pressure_for(0.5 * std::sqrt(2.0 - kRoot3));
    const EquilibriumErrors errors = equilibrium_errors(foam);
    const double segment = kSide * kSide / (2.0 - kRoot3) * (kPi / 12.0 - 0.25);
    EXPECT_NEAR(errors.area, 6.0 * segment, kRounding);
    EXPECT_NEAR(errors.angle, kPi / 6.0, kRounding);
    EXPECT_EQ(errors.films_at_limit, 0);
}

// Each of the six films of the bubble is pi/3 c long. The other 42 films are straight and c long.
TEST(Measure, EnergyIsTensionTimesLength) {
    Foam foam = honeycomb(4, 4);
    foam.film_tension = 3.0;
    foam.pressures[BubbleId{5}] = 3.0 * pressure_for(0.5);
    EXPECT_NEAR(energy(foam), 3.0 * (42.0 + 6.0 * kPi / 3.0) * kSide, 1e-13);
}

// The half angles are 79 and 81 degrees, one degree below and above the limit.
TEST(Measure, CountsTheFilmsAtTheLimit) {
    Foam foam = honeycomb(4, 4);
    foam.pressures[BubbleId{5}] = pressure_for(std::sin(79.0 * kPi / 180.0));
    EXPECT_EQ(equilibrium_errors(foam).films_at_limit, 0);
    foam.pressures[BubbleId{5}] = pressure_for(std::sin(81.0 * kPi / 180.0));
    EXPECT_EQ(equilibrium_errors(foam).films_at_limit, 6);
    foam.pressures[BubbleId{5}] = -pressure_for(std::sin(81.0 * kPi / 180.0));
    EXPECT_EQ(equilibrium_errors(foam).films_at_limit, 6);
}

TEST(Measure, AreaErrorIsRelativeToTheTarget) {
    Foam foam = honeycomb(4, 4);
    foam.target_areas[BubbleId{3}] = 0.8;  // the area is 1, 25 % too large
    foam.target_areas[BubbleId{4}] = 1.2;  // 17 % too small
    EXPECT_NEAR(equilibrium_errors(foam).area, 0.25, kRounding);
}

// Bubble 5 is mirrored at the vertical line through its middle, so that its half-edges run
// clockwise.
TEST(Measure, AnInvertedBubbleHasANegativeArea) {
    Foam foam = honeycomb(4, 4);
    const double middle = 2.0 * kRoot3 * kSide;  // bubble 5 is second in a shifted row
    for (const HalfEdgeId h : foam.network.around(BubbleId{5})) {
        Vec2& corner = foam.positions[foam.network.tail(h)];
        corner.x() = 2.0 * middle - corner.x();
    }
    EXPECT_NEAR(bubble_area(foam, BubbleId{5}), -1.0, kRounding);
}

TEST(Measure, AFilmWithoutLengthHasNoAngles) {
    Foam foam = honeycomb(4, 4);
    const HalfEdgeId h = foam.network.first(BubbleId{5});
    foam.positions[foam.network.tail(h)] = foam.positions[foam.network.head(h)];
    EXPECT_EQ(equilibrium_errors(foam).angle, kPi);
}

TEST(Measure, AFoamThatIsNotFiniteIsNotExact) {
    Foam foam = honeycomb(4, 4);
    foam.pressures[BubbleId{5}] = std::numeric_limits<double>::quiet_NaN();
    const EquilibriumErrors errors = equilibrium_errors(foam);
    EXPECT_TRUE(std::isnan(errors.area));
    EXPECT_TRUE(std::isnan(errors.angle));
}

TEST(Measure, CenteredPressuresHaveAWeightedMeanOfZero) {
    Foam foam = bent_foam(50, 2.0, 3);
    for (double& pressure : foam.pressures) {
        pressure += 100.0;
    }
    const Foam before = foam;
    center_pressures(foam);
    double weighted = 0.0;
    for (const BubbleId bubble : foam.network.bubbles()) {
        weighted += foam.target_areas[bubble] * foam.pressures[bubble];
    }
    EXPECT_NEAR(weighted, 0.0, 50.0 * 100.0 * kRounding);
    for (const FilmId film : foam.network.films()) {
        const HalfEdgeId h = forward_side(film);
        EXPECT_NEAR(
            pressure_difference(foam, h), pressure_difference(before, h), 100.0 * kRounding);
    }
}

// The areas are 1 and 3. The weighted mean of the pressures 6 and 2 is (6 + 6) / 4 = 3.
TEST(Measure, CenteringWeighsWithTheTargetAreas) {
    Foam foam = honeycomb(1, 2);
    foam.target_areas[BubbleId{0}] = 1.0;
    foam.target_areas[BubbleId{1}] = 3.0;
    foam.pressures[BubbleId{0}] = 6.0;
    foam.pressures[BubbleId{1}] = 2.0;
    center_pressures(foam);
    EXPECT_DOUBLE_EQ(foam.pressures[BubbleId{0}], 3.0);
    EXPECT_DOUBLE_EQ(foam.pressures[BubbleId{1}], -1.0);
}

TEST(Measure, DeadSlotsHaveNoArea) {
    Foam foam = honeycomb(4, 4);
    foam.network.remove(BubbleId{5});
    const Indexed<BubbleId, double> areas = bubble_areas(foam);
    EXPECT_EQ(areas.size(), 16U);
    EXPECT_EQ(areas[BubbleId{5}], 0.0);
    EXPECT_NEAR(areas[BubbleId{6}], 1.0, kRounding);
}

// A circle of the area pi has the radius 1.
TEST(Measure, PressureOfALoneBubbleIsTensionDividedByRadius) {
    EXPECT_NEAR(lone_pressure({.target_area = kPi}, 3.0), 3.0, kRounding);
}

}  // namespace
}  // namespace foam
