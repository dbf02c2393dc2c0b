// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/foam/foam.h"
#include "core/foam/topology_thresholds.h"
#include "core/reference/block_step.h"

namespace foam {

/// The order in which a sweep visits the junctions.
enum class SweepOrder {
    Sequential,  // by id, each block from the state left by the one before (paper)
    Colored,     // color by color, all blocks of a color at once (paper, future work)
};

/// Options of `gauss_seidel`.
struct GaussSeidelOptions {
    // Converged when the errors of the foam are below this (EquilibriumErrors::are_below).
    double tolerance = 1e-4;
    int max_sweeps = 10000;
    SweepOrder order = SweepOrder::Sequential;
    // Used by colored sweeps, as in parallel_for; the result has the same bits for any number.
    int threads = 0;
    // Largest change of a block in a sweep. Pressures are in film tensions over the square root of
    // the bubble's target area, the motion of the junction is in lengths of its shortest film, half
    // angles of outer films are in radians.
    double largest_change = 0.4;
    DifferenceOptions differences{};
    TopologyThresholds thresholds{};
};

/// How the sweeps ended.
enum class GaussSeidelStatus { Converged, SweepLimit };

/// The result of `gauss_seidel`.
struct GaussSeidelSummary {
    GaussSeidelStatus status = GaussSeidelStatus::SweepLimit;
    int sweeps = 0;
    int t1 = 0;
};

/// Runs the paper's solver (E5): sweeps over the junctions, with T1s (E7) between sweeps. Each
/// junction is moved together with the pressures of its bubbles by the Newton step of its block
/// (block_step.h).
///
/// Stops as soon as the errors are below the tolerance, even if a film is below its T1 distance
/// then. Preconditions: those of `equilibrate`.
GaussSeidelSummary gauss_seidel(Foam& foam, const GaussSeidelOptions& options);

}  // namespace foam
