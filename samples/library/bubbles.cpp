// SPDX-License-Identifier: Apache-2.0

// Seeds a foam on a torus, lets gas diffuse, and compares the growth of the bubbles with von
// Neumann's law, dA/dt = (2 pi / 3) gamma kappa (n - 6), for bubbles of n sides.

#include <foamtex/foam.h>

#include <cstdio>
#include <map>
#include <numbers>

int main() try {
    foamtex::Foam foam = foamtex::Foam::torus({.bubbles = 500, .seed = 7});
    if (!foam.relax().converged) {
        throw foamtex::EquilibriumError("the foam found no equilibrium");
    }
    const foamtex::StepSettings settings{.kappa = 0.01};
    constexpr double kTime = 0.01;
    std::map<std::int64_t, foamtex::Bubble> before;
    for (const foamtex::Bubble& bubble : foam.records().bubbles) {
        before[bubble.identity] = bubble;
    }
    if (!foam.step(kTime, {}, settings).converged) {
        throw foamtex::EquilibriumError("the foam found no equilibrium");
    }

    std::map<std::int64_t, std::pair<double, int>> growth;  // sum and number, by sides
    for (const foamtex::Bubble& bubble : foam.records().bubbles) {
        if (bubble.sides == before[bubble.identity].sides) {
            auto& [sum, count] = growth[bubble.sides];
            sum += (bubble.area - before[bubble.identity].area) / kTime;
            ++count;
        }
    }
    std::printf("sides bubbles measured   law\n");
    for (const auto& [sides, found] : growth) {
        const double gamma = 0.5 * foam.film_tension();
        const double law = 2.0 * std::numbers::pi / 3.0 * gamma * settings.kappa *
                           (static_cast<double>(sides) - 6.0);
        std::printf("%5d %7d %+8.5f %+8.5f\n",
                    static_cast<int>(sides),
                    found.second,
                    found.first / found.second,
                    law);
    }
    return 0;
} catch (const foamtex::Error& error) {
    std::fprintf(stderr, "bubbles: %s\n", error.what());
    return 1;
}
