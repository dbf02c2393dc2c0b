// SPDX-License-Identifier: Apache-2.0

#include "tests/stress/foam_case.h"

#include "core/foam/patch.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <vector>

namespace foam::stress {

namespace {

constexpr int kManyBubbles = 1000;
constexpr std::uint64_t kOutlineSalt =
    0x6f75746c696e6573;  // makes outlines independent of the case

std::vector<Vec2> random_star(Random& random) {
    const auto corners = static_cast<int>(3 + random.below(14));
    std::vector<Vec2> star;
    for (int k = 0; k < corners; ++k) {
        const double angle = 2.0 * std::numbers::pi * k / corners;
        const double distance = uniform(random, 0.3, 1.0);
        star.emplace_back(distance * std::cos(angle), distance * std::sin(angle));
    }
    return star;
}

// Returns a smaller copy of an outline, clockwise as a hole must be.
std::vector<Vec2> shrunk(std::vector<Vec2> ring, double factor) {
    std::reverse(ring.begin(), ring.end());
    for (Vec2& corner : ring) {
        corner *= factor;
    }
    return ring;
}

Outline random_outline(Random& random) {
    Outline outline{random_star(random), {}};
    const double hole = uniform(random, 0.1, 0.7);
    if (random.below(3) == 0) {
        outline.holes.push_back(shrunk(outline.outer, hole));
    }
    return outline;
}

double total_area(const Foam& foam) {
    if (!foam.domain.is_plane()) {
        return foam.domain.area();
    }
    double total = 0.0;
    for (const BubbleId bubble : foam.network.bubbles()) {
        total += foam.target_areas[bubble];
    }
    return std::accumulate(foam.lone_bubbles.begin(),
                           foam.lone_bubbles.end(),
                           total,
                           [](double sum, const LoneBubble& b) { return sum + b.target_area; });
}

std::string describe(const Outline& outline) {
    return fmt::format("{} corners{}", outline.outer.size(), outline.holes.empty() ? "" : ", hole");
}

}  // namespace

double uniform(Random& random, double low, double high) {
    return low + (high - low) * random.uniform();
}

double log_uniform(Random& random, double low, double high) {
    return low * std::pow(high / low, random.uniform());
}

// A new parameter must be drawn last. Otherwise every seed would give a different case.
FoamCase draw_case(std::uint64_t seed) {
    Random random(~seed);  // the seed itself is used for the diagram
    FoamCase drawn;
    SeedingOptions& seeding = drawn.seeding;
    TopologyThresholds& thresholds = drawn.step.equilibrium.thresholds;
    seeding.seed = seed;
    seeding.bubbles = static_cast<int>(log_uniform(random, 20.0, 5001.0));
    seeding.lloyd_iterations = static_cast<int>(random.below(6));
    const double ratio = log_uniform(random, 1.0, 100.0);
    seeding.area_ratio = random.below(4) == 0 ? 0.0 : ratio;
    seeding.aspect = log_uniform(random, 0.25, 4.0);
    thresholds.t1_distance = log_uniform(random, 0.01, 0.25);
    thresholds.t2_area = log_uniform(random, 0.01, 0.25);
    drawn.step.coarsening.kappa = log_uniform(random, 1e-3, 1e3);
    // With shorter frames, large foams would take most of the time of a run.
    const double min_fraction = seeding.bubbles > kManyBubbles ? 0.01 : 0.003;
    const double fraction = log_uniform(random, min_fraction, 0.05);
    drawn.frame_fraction = random.below(10) == 0 ? 0.5 : fraction;
    drawn.step.equilibrium.threads = 1;
    return drawn;
}

FoamCase draw_patch(std::uint64_t seed) {
    FoamCase drawn = draw_case(seed);
    Random random(seed ^ kOutlineSalt);
    drawn.outline = random_outline(random);
    return drawn;
}

Foam seed_case(const FoamCase& foam_case) {
    const SeedingOptions& seeding = foam_case.seeding;
    if (!foam_case.outline) {
        return seed_foam(seeding);
    }
    return seed_patch(*foam_case.outline,
                      {.bubbles = seeding.bubbles,
                       .lloyd_iterations = seeding.lloyd_iterations,
                       .area_ratio = seeding.area_ratio,
                       .seed = seeding.seed});
}

std::size_t bubbles_of(const Foam& foam) {
    return foam.network.bubble_count() + foam.lone_bubbles.size();
}

double frame_time(const Foam& foam, const FoamCase& foam_case) {
    const double mean_area = total_area(foam) / static_cast<double>(bubbles_of(foam));
    const double gamma = 0.5 * foam.film_tension;
    const double rate = 2.0 * std::numbers::pi / 3.0 * gamma * foam_case.step.coarsening.kappa;
    return foam_case.frame_fraction * mean_area / rate;
}

std::string describe(const FoamCase& foam_case) {
    const SeedingOptions& seeding = foam_case.seeding;
    const TopologyThresholds& thresholds = foam_case.step.equilibrium.thresholds;
    return fmt::format(
        "seed {}: {} bubbles, lloyd {}, ratio {:.3g}, {}, T1 {:.3g}, T2 {:.3g}, kappa {:.3g}, "
        "share {:.3g}",
        seeding.seed,
        seeding.bubbles,
        seeding.lloyd_iterations,
        seeding.area_ratio,
        foam_case.outline ? describe(*foam_case.outline)
                          : fmt::format("aspect {:.3g}", seeding.aspect),
        thresholds.t1_distance,
        thresholds.t2_area,
        foam_case.step.coarsening.kappa,
        foam_case.frame_fraction);
}

}  // namespace foam::stress
