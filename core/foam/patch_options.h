// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/foam/area_field.h"

#include <cstdint>
#include <optional>

namespace foam {

/// Options for seeding a patch.
struct PatchOptions {
    // The intended number of bubbles, at least 2. The patch may have another number: the share of
    // each part of the outline is rounded, the outline may divide cells, and small cells are merged
    // with their neighbors.
    int bubbles = 100;
    int lloyd_iterations = 0;      // iterations of Lloyd's algorithm; 0 keeps the random sites
    double area_ratio = 0.0;       // see SeedingOptions (seeding.h)
    double surface_tension = 0.5;  // gamma; a film has two surfaces, so its tension is 2 gamma
    std::uint64_t seed = 1;
    std::optional<AreaField> areas = std::nullopt;  // see SeedingOptions
};

}  // namespace foam
