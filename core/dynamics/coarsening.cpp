// SPDX-License-Identifier: Apache-2.0

#include "core/dynamics/coarsening.h"

#include <numbers>

namespace foam {

namespace {

double rate_of_sides(const Foam& foam, int sides, const CoarseningOptions& options) {
    const double gamma = 0.5 * foam.film_tension;
    return 2.0 * std::numbers::pi / 3.0 * gamma * options.kappa * (sides - 6);
}

}  // namespace

double growth_rate(const Foam& foam, BubbleId bubble, const CoarseningOptions& options) {
    return rate_of_sides(foam, foam.network.sides(bubble), options);
}

double lone_growth_rate(const Foam& foam, const CoarseningOptions& options) {
    return rate_of_sides(foam, 0, options);
}

void diffuse(Foam& foam, double time, const CoarseningOptions& options) {
    for (const BubbleId bubble : foam.network.bubbles()) {
        foam.target_areas[bubble] += time * growth_rate(foam, bubble, options);
    }
    for (LoneBubble& bubble : foam.lone_bubbles) {
        bubble.target_area += time * lone_growth_rate(foam, options);
    }
}

}  // namespace foam
