#pragma once

#include "core/foam/foam.h"
#include "core/foam/outline.h"

#include <cstdint>

namespace foam {

/// How the first diagram of a patch is drawn.
struct PatchOptions {
    int bubbles = 100;             // about: slivers are merged; two at least
    int lloyd_iterations = 0;      // 0 leaves the raw random diagram
    double area_ratio = 0.0;       // as in SeedingOptions
    double surface_tension = 0.5;  // gamma; a film has two surfaces, so its tension is 2 gamma
    std::uint64_t seed = 1;
};

/// The Voronoi diagram of random sites within an outline as a patch that is not yet in equilibrium:
/// cells cut off at the outline, small parts of them merged with their neighbours, its corners
/// dissolved into films. Scaled to a mean area of 1, around the origin. Throws
/// std::invalid_argument for options out of range or an outline without an area, std::runtime_error
/// where no draw gives a foam, as in an outline too narrow for its bubbles.
Foam seed_patch(const Outline& outline, const PatchOptions& options);

}  // namespace foam
