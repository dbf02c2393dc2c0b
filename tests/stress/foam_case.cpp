#include "tests/stress/foam_case.h"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

namespace foam::stress {

namespace {

constexpr int kManyBubbles = 1000;

}  // namespace

double uniform(Random& random, double low, double high) {
    return low + (high - low) * random.uniform();
}

double log_uniform(Random& random, double low, double high) {
    return low * std::pow(high / low, random.uniform());
}

// A new parameter must be drawn last, else every seed stands for another case.
FoamCase draw_case(std::uint64_t seed) {
    Random random(~seed);  // the seed itself draws the diagram
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
    // Shorter frames of large foams would take most of the time of a run.
    const double least_share = seeding.bubbles > kManyBubbles ? 0.01 : 0.003;
    const double share = log_uniform(random, least_share, 0.05);
    drawn.frame_share = random.below(10) == 0 ? 0.5 : share;
    drawn.step.equilibrium.threads = 1;
    return drawn;
}

double frame_time(const Foam& foam, const FoamCase& foam_case) {
    const double mean_area = foam.torus.area() / static_cast<double>(foam.network.bubble_count());
    const double gamma = 0.5 * foam.film_tension;
    const double rate = 2.0 * std::numbers::pi / 3.0 * gamma * foam_case.step.coarsening.kappa;
    return foam_case.frame_share * mean_area / rate;
}

std::string describe(const FoamCase& foam_case) {
    const SeedingOptions& seeding = foam_case.seeding;
    const TopologyThresholds& thresholds = foam_case.step.equilibrium.thresholds;
    return fmt::format(
        "seed {}: {} bubbles, lloyd {}, ratio {:.3g}, aspect {:.3g}, T1 {:.3g}, T2 {:.3g}, kappa "
        "{:.3g}, share {:.3g}",
        seeding.seed,
        seeding.bubbles,
        seeding.lloyd_iterations,
        seeding.area_ratio,
        seeding.aspect,
        thresholds.t1_distance,
        thresholds.t2_area,
        foam_case.step.coarsening.kappa,
        foam_case.frame_share);
}

}  // namespace foam::stress
