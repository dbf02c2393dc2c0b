#pragma once

#include "core/foam/foam.h"

#include <cstdint>

namespace foam {

/// How the first diagram of a periodic foam is drawn.
struct SeedingOptions {
    int bubbles = 1000;        // the torus has this area: the mean bubble area is 1
    double aspect = 1.0;       // width of the torus over its height
    int lloyd_iterations = 0;  // 0 leaves the raw random diagram
    double area_ratio = 0.0;   // largest over smallest target area, spread evenly in the logarithm;
                               // 0 takes the areas of the diagram itself
    double surface_tension = 0.5;  // gamma; a film has two surfaces, so its tension is 2 gamma
    std::uint64_t seed = 1;
};

/// The Voronoi diagram of random sites on a torus as a foam that is not yet in equilibrium:
/// straight films, every pressure 0. Where areas are spread, the cells keep their rank: the largest
/// cell gets the largest target. Throws std::invalid_argument for options out of range.
Foam seed_foam(const SeedingOptions& options);

}  // namespace foam
