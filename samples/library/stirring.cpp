// SPDX-License-Identifier: Apache-2.0

// A custom loop with custom forces: two pistons push through a foam on a torus in
// opposite directions, while one bubble is inflated. Prints the energy and the number of T1s.

#include <foamtex/foam.h>

#include <cmath>
#include <cstdio>

int main() try {
    foamtex::Foam foam = foamtex::Foam::torus({.bubbles = 300, .lloyd_iterations = 2, .seed = 3});
    if (!foam.relax().converged) {
        throw foamtex::EquilibriumError("the foam found no equilibrium");
    }
    const foamtex::Extent torus = foam.extent();
    const std::int64_t inflated = foam.records().bubbles.front().identity;
    int t1 = 0;
    std::printf("step energy   T1s  largest area\n");
    for (int step = 1; step <= 12; ++step) {
        const double x = torus.width * step / 12.0;
        foamtex::Drive drive;
        drive.areas = {{.identity = inflated, .target_area = 1.0 + 0.5 * step}};
        drive.pushes = {{{x, 0.25 * torus.height}, 2.5, {1.8, 0.0}},
                        {{torus.width - x, 0.75 * torus.height}, 2.5, {-1.8, 0.0}}};
        const foamtex::Equilibrium found = foam.step(0.0, drive);
        if (!found.converged) {
            throw foamtex::EquilibriumError("the foam found no equilibrium");
        }
        t1 += found.t1;
        double largest = 0.0;
        for (const foamtex::Bubble& bubble : foam.records().bubbles) {
            largest = std::fmax(largest, bubble.area);
        }
        std::printf("%4d %8.3f %4d %8.3f\n", step, foam.energy(), t1, largest);
    }
    return 0;
} catch (const foamtex::Error& error) {
    std::fprintf(stderr, "stirring: %s\n", error.what());
    return 1;
}
