// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/foam/foam.h"

#include <cstdint>

namespace foam {

/// Options for seeding a foam on a torus.
struct SeedingOptions {
    int bubbles = 1000;        // the torus has this area: the mean bubble area is 1
    double aspect = 1.0;       // width of the torus over its height
    int lloyd_iterations = 0;  // of Lloyd's algorithm; 0 leaves the raw random diagram
    double area_ratio = 0.0;   // largest over smallest target area, spread evenly in the logarithm;
                               // 0 keeps the areas of the diagram
    double surface_tension = 0.5;  // gamma; a film has two surfaces, so its tension is 2 gamma
    std::uint64_t seed = 1;
};

/// Returns the Voronoi diagram of random sites on a torus as a foam that is not yet in equilibrium:
/// films are straight and every pressure is 0. If target areas are spread, they are assigned by
/// rank: the largest cell gets the largest target area. Throws std::invalid_argument if an option
/// is out of range, and std::runtime_error if none of several random draws gives a valid foam.
Foam seed_foam(const SeedingOptions& options);

}  // namespace foam
