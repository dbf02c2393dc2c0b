#include "core/dynamics/coarsening.h"

#include <numbers>

namespace foam {

double growth_rate(const Foam& foam, BubbleId bubble, const CoarseningOptions& options) {
    const double gamma = 0.5 * foam.film_tension;
    return 2.0 * std::numbers::pi / 3.0 * gamma * options.kappa * (foam.network.sides(bubble) - 6);
}

void diffuse(Foam& foam, double time, const CoarseningOptions& options) {
    for (const BubbleId bubble : foam.network.bubbles()) {
        foam.target_areas[bubble] += time * growth_rate(foam, bubble, options);
    }
}

}  // namespace foam
