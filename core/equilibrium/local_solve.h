// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/equilibrium/defect_regions.h"
#include "core/equilibrium/equilibrium_options.h"
#include "core/equilibrium/newton_system.h"
#include "core/equilibrium/soft_foam.h"

#include <cstddef>
#include <vector>

namespace foam {

/// Buffers that are reused from region to region. Allocating them for each region would be costly,
/// since SoftFoam has a slot for every bubble and film of the whole foam.
struct RegionBuffers {
    explicit RegionBuffers(Foam& foam) : soft(foam) {}

    NewtonSystem system;
    SoftFoam soft;
};

/// The work of `solve_defect_regions`.
struct LocalSummary {
    std::size_t regions = 0;
    int t1 = 0;
};

/// Runs Newton's method on each defect region of the foam, with everything else held, and makes the
/// T1s that it asks for. A region in which it stalls is relaxed once; otherwise the region would
/// stop every step of the whole foam. The tolerance is loose, since the surroundings move later.
/// Does nothing if there are no regions (find_defect_regions).
LocalSummary solve_defect_regions(Foam& foam,
                                  const EquilibriumOptions& options,
                                  RegionBuffers& buffers);

/// Returns the regions around defects whose residual is at least a fifth of the largest residual of
/// the foam. Returns none if they would hold too large a share of the foam.
std::vector<DefectRegion> worst_regions(const Foam& foam, int threads);

/// Relaxes each of the regions, with everything else held. Returns the number of T1s.
int relax_regions(Foam& foam,
                  std::vector<DefectRegion> regions,
                  const EquilibriumOptions& options,
                  RegionBuffers& buffers);

}  // namespace foam
