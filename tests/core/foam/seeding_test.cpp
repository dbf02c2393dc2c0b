// SPDX-License-Identifier: Apache-2.0

#include "core/foam/seeding.h"

#include "core/foam/measure.h"
#include "tests/core/foams.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <stdexcept>
#include <vector>

namespace foam {
namespace {

using test::are_same;
using test::is_valid;

SeedingOptions options_for(int bubbles, std::uint64_t seed) {
    SeedingOptions options;
    options.bubbles = bubbles;
    options.seed = seed;
    return options;
}

std::vector<double> targets_of(const Foam& foam) {
    return {foam.target_areas.begin(), foam.target_areas.end()};
}

double variance(const std::vector<double>& values) {
    const double count = static_cast<double>(values.size());
    const double mean = std::accumulate(values.begin(), values.end(), 0.0) / count;
    double sum = 0.0;
    for (const double value : values) {
        sum += (value - mean) * (value - mean);
    }
    return sum / count;
}

TEST(Seeding, MakesAValidFoamOfStraightFilms) {
    for (const int bubbles : {2, 3, 4, 7, 50, 300}) {
        for (std::uint64_t seed = 0; seed < 10; ++seed) {
            const Foam foam = seed_foam(options_for(bubbles, seed));
            EXPECT_TRUE(is_valid(foam.network));
            EXPECT_EQ(foam.network.bubble_count(), static_cast<std::size_t>(bubbles));
            EXPECT_TRUE(std::all_of(
                foam.pressures.begin(), foam.pressures.end(), [](double p) { return p == 0.0; }));
        }
    }
}

TEST(Seeding, TheMeanAreaIsOne) {
    for (const double ratio : {0.0, 1.0, 100.0}) {
        SeedingOptions options = options_for(200, 4);
        options.area_ratio = ratio;
        const Foam foam = seed_foam(options);
        EXPECT_NEAR(foam.domain.area(), 200.0, 1e-11);
        EXPECT_NEAR(test::total_target(foam), foam.domain.area(), 1e-11);
    }
}

// Without a ratio, target areas are the areas of the diagram, except for the rounding of the torus
// to the grid.
TEST(Seeding, TargetsAreTheAreasOfTheDiagram) {
    const Foam foam = seed_foam(options_for(200, 4));
    for (const BubbleId bubble : foam.network.bubbles()) {
        EXPECT_NEAR(foam.target_areas[bubble], bubble_area(foam, bubble), 1e-6);
    }
}

TEST(Seeding, BubblesAreNumberedFromZero) {
    const Foam foam = seed_foam(options_for(20, 1));
    EXPECT_EQ(foam.next_identity, 20U);
    EXPECT_EQ(foam.time, 0.0);
    for (const BubbleId bubble : foam.network.bubbles()) {
        EXPECT_EQ(foam.identities[bubble], index_of(bubble));
    }
}

TEST(Seeding, TheSameSeedGivesTheSameBits) {
    SeedingOptions options = options_for(150, 12);
    options.lloyd_iterations = 2;
    options.area_ratio = 10.0;
    EXPECT_TRUE(are_same(seed_foam(options), seed_foam(options)));
}

TEST(Seeding, AnotherSeedGivesAnotherFoam) {
    EXPECT_FALSE(are_same(seed_foam(options_for(150, 12)), seed_foam(options_for(150, 13))));
}

TEST(Seeding, AFilmHasTwoSurfaces) {
    SeedingOptions options = options_for(10, 1);
    options.surface_tension = 0.7;
    EXPECT_DOUBLE_EQ(seed_foam(options).film_tension, 1.4);
}

// A torus of area 12 that is four times as wide as high has the height sqrt(3).
TEST(Seeding, TheTorusHasItsAspect) {
    SeedingOptions options = options_for(12, 1);
    options.aspect = 4.0;
    const Domain domain = seed_foam(options).domain;
    EXPECT_NEAR(domain.height, std::sqrt(3.0), 1e-14);
    EXPECT_NEAR(domain.width, 4.0 * std::sqrt(3.0), 1e-14);
}

// If areas are sorted, each area is 100^(1/99) times the area before it. The largest area is 100
// times the smallest.
TEST(Seeding, AreasAreSpreadEvenlyInTheLogarithm) {
    SeedingOptions options = options_for(100, 9);
    options.area_ratio = 100.0;
    std::vector<double> areas = targets_of(seed_foam(options));
    std::sort(areas.begin(), areas.end());
    EXPECT_NEAR(areas.back() / areas.front(), 100.0, 1e-11);
    for (std::size_t k = 0; k + 1 < areas.size(); ++k) {
        EXPECT_NEAR(areas[k + 1] / areas[k], std::pow(100.0, 1.0 / 99.0), 1e-13);
    }
}

TEST(Seeding, SpreadAreasKeepTheRankOfTheCells) {
    SeedingOptions options = options_for(100, 9);
    const std::vector<double> own = targets_of(seed_foam(options));
    options.area_ratio = 100.0;
    const std::vector<double> spread = targets_of(seed_foam(options));
    for (std::size_t a = 0; a < own.size(); ++a) {
        for (std::size_t b = 0; b < own.size(); ++b) {
            EXPECT_EQ(own[a] < own[b], spread[a] < spread[b]);
        }
    }
}

TEST(Seeding, ARatioOfOneMakesAllTargetsEqual) {
    SeedingOptions options = options_for(50, 2);
    options.area_ratio = 1.0;
    for (const double area : targets_of(seed_foam(options))) {
        EXPECT_NEAR(area, 1.0, 1e-14);
    }
}

// The areas of raw diagrams have a variance of 0.28. Lloyd iterations make the areas more equal.
TEST(Seeding, LloydIterationsEvenTheAreasOut) {
    for (std::uint64_t seed = 1; seed <= 5; ++seed) {
        SeedingOptions options = options_for(300, seed);
        double before = std::numeric_limits<double>::infinity();
        for (const int iterations : {0, 1, 3, 10}) {
            options.lloyd_iterations = iterations;
            const double now = variance(targets_of(seed_foam(options)));
            EXPECT_LT(now, 0.8 * before);
            before = now;
        }
        EXPECT_LT(before, 0.05);
    }
}

// The variance of the areas of a Poisson-Voronoi diagram in the plane is 0.2802 (Gilbert 1962). Its
// mean over 20 diagrams of 500 cells has a standard deviation of about 0.005.
TEST(Seeding, RawDiagramsArePoissonVoronoi) {
    double sum = 0.0;
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
        sum += variance(targets_of(seed_foam(options_for(500, seed))));
    }
    EXPECT_NEAR(sum / 20.0, 0.2802, 0.02);
}

TEST(Seeding, RejectsOptionsOutOfRange) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const auto expect_rejected = [](auto change) {
        SeedingOptions options;
        options.bubbles = 10;
        change(options);
        EXPECT_THROW(seed_foam(options), std::invalid_argument);
    };
    for (const int bubbles : {0, -5}) {
        expect_rejected([&](SeedingOptions& o) { o.bubbles = bubbles; });
    }
    for (const double value : {0.0, -1.0, nan}) {
        expect_rejected([&](SeedingOptions& o) { o.aspect = value; });
        expect_rejected([&](SeedingOptions& o) { o.surface_tension = value; });
    }
    for (const double ratio : {0.5, -2.0, nan}) {
        expect_rejected([&](SeedingOptions& o) { o.area_ratio = ratio; });
    }
}

// The cell of a single site on a rectangular torus is a rectangle, whose corners join four cells.
TEST(Seeding, OneBubbleMakesNoFoam) {
    EXPECT_THROW(seed_foam(options_for(1, 1)), std::runtime_error);
}

// The field of a torus whose left half has bubbles a quarter as large as its right half.
SeedingOptions half_fine(double area_ratio) {
    SeedingOptions options = options_for(1000, 3);
    options.aspect = 2.0;
    options.lloyd_iterations = 4;
    options.area_ratio = area_ratio;
    options.areas = AreaField(2, 1, {1.0, 4.0});
    return options;
}

double center_of(const Foam& foam, BubbleId bubble) {
    const Vec2 corner = foam.positions[foam.network.tail(foam.network.first(bubble))];
    return corner.x();
}

// With a density of 1 / area, four of five bubbles are on the left. The targets of all bubbles
// within one half are equal; those on the right are four times as large.
TEST(Seeding, AFieldDecidesTheNumberOfBubblesAndTheirAreas) {
    const Foam foam = seed_foam(half_fine(0.0));
    EXPECT_TRUE(is_valid(foam.network));
    EXPECT_NEAR(test::total_target(foam), foam.domain.area(), 1e-9);
    const double small = *std::min_element(foam.target_areas.begin(), foam.target_areas.end());
    EXPECT_NEAR(small, 0.625, 0.05);
    int left = 0;
    for (const BubbleId bubble : foam.network.bubbles()) {
        const double x = center_of(foam, bubble) / foam.domain.width;
        left += x < 0.5 ? 1 : 0;
        if (x > 0.1 && x < 0.4) {
            EXPECT_NEAR(foam.target_areas[bubble], small, 1e-9);
        }
        if (x > 0.6 && x < 0.9) {
            EXPECT_NEAR(foam.target_areas[bubble], 4.0 * small, 1e-9);
        }
    }
    EXPECT_NEAR(left, 800, 40);
}

// Targets relative to the field span the ratio. Bubbles across the border have areas between.
TEST(Seeding, AreasSpreadAroundTheField) {
    const Foam foam = seed_foam(half_fine(9.0));
    double smallest = 1e9;
    double largest = 0.0;
    for (const BubbleId bubble : foam.network.bubbles()) {
        const double x = center_of(foam, bubble) / foam.domain.width;
        if (x > 0.1 && x < 0.4) {
            smallest = std::min(smallest, foam.target_areas[bubble]);
            largest = std::max(largest, foam.target_areas[bubble]);
        }
    }
    EXPECT_NEAR(largest / smallest, 9.0, 0.3);
}

// Lloyd's algorithm makes the areas of cells follow the field more closely than random sites do.
TEST(Seeding, WeightedLloydIterationsKeepTheDensity) {
    SeedingOptions options = half_fine(0.0);
    options.lloyd_iterations = 30;
    const Foam foam = seed_foam(options);
    std::vector<double> relative;
    for (const BubbleId bubble : foam.network.bubbles()) {
        const double x = center_of(foam, bubble) / foam.domain.width;
        if ((x > 0.1 && x < 0.4) || (x > 0.6 && x < 0.9)) {
            relative.push_back(bubble_area(foam, bubble) / foam.target_areas[bubble]);
        }
    }
    EXPECT_LT(variance(relative), 0.02);
    options.lloyd_iterations = 0;
    const Foam random = seed_foam(options);
    relative.clear();
    for (const BubbleId bubble : random.network.bubbles()) {
        relative.push_back(bubble_area(random, bubble) / random.target_areas[bubble]);
    }
    EXPECT_GT(variance(relative), 0.15);
}

}  // namespace
}  // namespace foam
