// SPDX-License-Identifier: Apache-2.0

#include "texgen/raster/distance/arc_view.h"

#include "tests/support/simd_levels.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

namespace foam::texgen {
namespace {

struct FilmAt {
    FilmArc film;  // pixels
    Vec2 tail;
};

// Returns random arcs that turn by up to 120 degrees, like the arcs of a Boundary.
std::vector<FilmAt> random_arcs(std::size_t count, std::mt19937& random) {
    std::uniform_real_distribution<double> uniform(-1.0, 1.0);
    std::vector<FilmAt> arcs;
    for (std::size_t k = 0; k < count; ++k) {
        const Vec2 chord(10.0 * uniform(random), 10.0 * uniform(random));
        const Vec2 tail(30.0 * uniform(random), 30.0 * uniform(random));
        arcs.push_back({{chord, 1.04 * uniform(random)}, tail});
    }
    return arcs;
}

// Returns the distance from a point to the nearest of 2001 points of an arc. If this is a pixel or
// more, it is too large by less than 1e-4.
double sampled_distance(const FilmAt& arc, const Vec2& point) {
    constexpr int kSamples = 2000;
    double min_distance = std::numeric_limits<double>::infinity();
    for (int k = 0; k <= kSamples; ++k) {
        const Vec2 at = arc.tail + point_at(arc.film, static_cast<double>(k) / kSamples);
        min_distance = std::min(min_distance, (at - point).norm());
    }
    return min_distance;
}

std::vector<DistanceArc> distance_arcs(const std::vector<FilmAt>& films) {
    std::vector<DistanceArc> arcs;
    for (const FilmAt& film : films) {
        arcs.push_back({film.tail, pixel_arc(film.film)});
    }
    return arcs;
}

TEST(ArcView, BoundAndMeasureTheDistanceOfEachArc) {
    at_every_simd_level([] {
        std::mt19937 random(3);
        std::uniform_real_distribution<double> uniform(-40.0, 40.0);
        for (int round = 0; round < 20; ++round) {
            const std::vector<FilmAt> arcs = random_arcs(19, random);
            ArcView view;
            const Vec2 point(uniform(random), uniform(random));
            view.evaluate(distance_arcs(arcs), point);
            for (std::size_t k = 0; k < arcs.size(); ++k) {
                const double distance = sampled_distance(arcs[k], point);
                EXPECT_TRUE(view.is_within(k, distance + 1e-9));
                const ArcFunctions f = view.arc_functions(k);
                if (f.past_tail.value >= 0.0F && f.before_head.value >= 0.0F) {
                    const double slope = std::hypot(f.across.x, f.across.y);
                    EXPECT_NEAR(std::abs(f.across.twice_value) / (1.0 + slope), distance, 2e-3);
                    EXPECT_FALSE(view.is_within(k, distance - 2e-3));
                }
            }
        }
    });
}

// An arc beyond the horizon is not the nearest arc of any point within reach.
TEST(ArcView, HorizonHoldsTheNearestArcOfAllPointsWithinReach) {
    std::mt19937 random(5);
    std::uniform_real_distribution<double> uniform(-20.0, 20.0);
    std::size_t dropped = 0;
    for (int round = 0; round < 20; ++round) {
        const std::vector<FilmAt> arcs = random_arcs(30, random);
        ArcView view;
        const Vec2 middle(uniform(random), uniform(random));
        constexpr double kReach = 4.0;
        view.evaluate(distance_arcs(arcs), middle);
        const double horizon = view.horizon(kReach);
        for (int sample = 0; sample < 8; ++sample) {
            const double turn = sample * 0.785;
            const Vec2 point = middle + kReach * Vec2(std::cos(turn), std::sin(turn));
            std::size_t nearest = 0;
            for (std::size_t k = 1; k < arcs.size(); ++k) {
                if (sampled_distance(arcs[k], point) < sampled_distance(arcs[nearest], point)) {
                    nearest = k;
                }
            }
            EXPECT_TRUE(view.is_within(nearest, horizon));
        }
        for (std::size_t k = 0; k < arcs.size(); ++k) {
            dropped += view.is_within(k, horizon) ? 0U : 1U;
        }
    }
    EXPECT_GT(dropped, 100U);
}

// `across` is 0 on the arc. `along` is 0 on the circle that crosses the arc at right angles at its
// ends, and positive on the arc between them. At the ends, the gradients of both are perpendicular
// unit vectors.
TEST(ArcView, FunctionsOfAFilmVanishAtItsEnds) {
    at_every_simd_level([] {
        const FilmArc film{{6.0, 2.0}, 0.8};
        const Vec2 tail(1.0, -3.0);
        const std::vector<DistanceArc> arcs{{tail, pixel_arc(film)}};
        ArcView view;
        for (const double fraction : {0.0, 0.25, 0.5, 1.0}) {
            view.evaluate(arcs, tail + point_at(film, fraction));
            const FilmFunctions f = view.film_functions(0);
            EXPECT_NEAR(f.across.twice_value, 0.0, 1e-6);
            EXPECT_NEAR(std::hypot(f.across.x, f.across.y), 1.0, 1e-6);
            const bool is_end = fraction == 0.0 || fraction == 1.0;
            EXPECT_NEAR(f.along.twice_value > 1e-6F ? 1.0 : 0.0, is_end ? 0.0 : 1.0, 0.0);
            if (is_end) {
                EXPECT_NEAR(f.along.twice_value, 0.0, 1e-6);
                EXPECT_NEAR(std::hypot(f.along.x, f.along.y), 1.0, 1e-6);
                EXPECT_NEAR(f.along.x * f.across.x + f.along.y * f.across.y, 0.0, 1e-6);
            }
        }
        EXPECT_NEAR(view.film_functions(0).chord, film.chord.norm(), 1e-6);
    });
}

}  // namespace
}  // namespace foam::texgen
