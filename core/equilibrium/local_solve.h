// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/equilibrium/defect_regions.h"
#include "core/equilibrium/equilibrium_options.h"
#include "core/equilibrium/newton_system.h"
#include "core/equilibrium/soft_foam.h"

#include <cstddef>
#include <vector>

namespace foam {

/// Buffers of one foam that are reused from region to region. Allocating them for each region would
/// be costly, since SoftFoam has a slot for every bubble and film of the whole foam.
struct RegionBuffers {
    explicit RegionBuffers(Foam& foam) : soft(foam) {}

    NewtonSystem system;
    SoftFoam soft;
};

/// Counts the work of `solve_defect_regions`.
struct LocalSummary {
    std::size_t regions = 0;  // number of regions found
    int t1 = 0;               // number of T1s
};

/// Runs Newton's method on each region around defects (find_defect_regions), with everything else
/// held fixed, and applies the T1s that the method requests. If the method stalls or reaches its
/// limit of iterations in a region, the region is relaxed once. Without relaxation, the unsolved
/// region would also stall Newton's method on the whole foam. The tolerance is loose, since the
/// surroundings of a region move later. Does nothing if find_defect_regions finds no region.
LocalSummary solve_defect_regions(Foam& foam,
                                  const DefectOptions& defects,
                                  const EquilibriumOptions& options,
                                  RegionBuffers& buffers);

/// The largest number of rings of neighbors in worst_regions.
inline constexpr int kWorstRings = 3;

/// Returns the regions around the worst defects (DefectOptions). A defect is among the worst if its
/// force is at least a fifth of the largest force in the foam (ResidualNorms::force). It is also
/// among the worst if its area error is at least a fifth of the largest area error. Three rings of
/// neighbors around these defects belong to the regions, or fewer, but at least `fewest_rings`, if
/// the regions would otherwise contain more than DefectOptions::largest_fraction of the bubbles.
/// Returns no region if there is no such defect, or if the regions are too large even so.
std::vector<DefectRegion> worst_regions(const Foam& foam, int threads, int fewest_rings = 1);

/// Relaxes each of the regions, with everything else held fixed. Returns the number of T1s.
int relax_regions(Foam& foam,
                  std::vector<DefectRegion> regions,
                  const EquilibriumOptions& options,
                  RegionBuffers& buffers);

}  // namespace foam
