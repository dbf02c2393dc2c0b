#pragma once

#include "core/equilibrium/defect_regions.h"
#include "core/equilibrium/equilibrium_options.h"
#include "core/equilibrium/newton_system.h"
#include "core/equilibrium/soft_foam.h"

#include <cstddef>
#include <vector>

namespace foam {

/// Buffers for one region after another: for the whole foam they are costly to allocate and clear.
struct LocalMemory {
    explicit LocalMemory(Foam& foam) : soft(foam) {}

    NewtonSystem system;
    SoftFoam soft;
};

struct LocalSummary {
    std::size_t regions = 0;
    int t1 = 0;
};

/// Runs Newton's method on each defect region of the foam, with everything else held, and makes the
/// T1s that it asks for. A region in which it stalls is relaxed once: left as it is, it would stop
/// every step of the whole foam. The regions are solved loosely, since their surroundings move
/// again. Does nothing if there are no regions (find_defect_regions).
LocalSummary solve_defect_regions(Foam& foam,
                                  const EquilibriumOptions& options,
                                  LocalMemory& memory);

/// Returns the regions in which the residual is of the order of its largest. Returns none if they
/// hold a large share of the foam.
std::vector<DefectRegion> worst_regions(const Foam& foam, int threads);

/// Relaxes each of the regions, with everything else held. Returns the number of T1s.
int relax_regions(Foam& foam,
                  std::vector<DefectRegion> regions,
                  const EquilibriumOptions& options,
                  LocalMemory& memory);

}  // namespace foam
