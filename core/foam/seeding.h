// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/foam/area_field.h"
#include "core/foam/foam.h"

#include <cstdint>
#include <optional>

namespace foam {

/// Options for seeding a foam on a torus.
struct SeedingOptions {
    int bubbles = 1000;        // also the area of the torus, because the mean bubble area is 1
    double aspect = 1.0;       // width of the torus divided by its height
    int lloyd_iterations = 0;  // iterations of Lloyd's algorithm; 0 keeps the random sites
    /// The largest target area divided by the smallest, if there is no field of areas (`areas`).
    /// The logarithms of the target areas are evenly spaced. If the ratio is 0, the target areas
    /// are the areas of the Voronoi cells.
    double area_ratio = 0.0;
    double surface_tension = 0.5;  // gamma; a film has two surfaces, so its tension is 2 gamma
    std::uint64_t seed = 1;
    /// The field of the relative areas of bubbles at every point. It is stretched over the torus
    /// (PatchOptions::areas: over the bounding box of the outline of the patch). Sites are denser
    /// where bubbles should be small, and Lloyd's algorithm is weighted. Every target area is
    /// proportional to the value of the field at its cell. If `area_ratio` is not 0, every target
    /// area is also proportional to a factor from 1 to `area_ratio`. If there is no field, the mean
    /// area of bubbles is the same everywhere.
    std::optional<AreaField> areas = std::nullopt;
};

/// Returns the Voronoi diagram of random sites on a torus as a foam that is not yet in equilibrium:
/// films are straight and every pressure is 0. If `area_ratio` is not 0, the target areas are
/// assigned by rank: the largest cell gets the largest target area. With a field of areas, cells
/// are ranked by their area divided by the value of the field. Throws std::invalid_argument if an
/// option is out of range, and std::runtime_error if none of several random draws gives a valid
/// foam.
Foam seed_foam(const SeedingOptions& options);

}  // namespace foam
