// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/foam/foam.h"
#include "core/foam/topology_thresholds.h"
#include "core/reference/block_step.h"

namespace foam {

/// The order in which a sweep visits the junctions.
enum class SweepOrder {
    // Junctions are visited in the order of their ids. Each block starts from the state after the
    // block before it, as in the paper.
    Sequential,
    // Every junction has a color, such that two junctions of a color share no bubble except the
    // ghost (color_junctions). Junctions are visited color by color. All blocks of a color start
    // from the same state. The paper mentions this order as future work.
    Colored,
};

/// Options of `gauss_seidel`.
struct GaussSeidelOptions {
    // The sweeps have converged when the errors of the foam are below this tolerance
    // (EquilibriumErrors::are_below).
    double tolerance = 1e-4;
    int max_sweeps = 10000;
    SweepOrder order = SweepOrder::Sequential;
    // Number of threads of colored sweeps, with the same meaning as in thread_count. The result has
    // the same bits for any number of threads.
    int threads = 0;
    // Limit of one Newton step of a block, in the dimensionless units of JunctionBlock. The limit
    // applies to the change of each pressure, to the change of each half angle, and to the distance
    // by which the junction moves. A step that exceeds the limit is scaled down as a whole.
    double largest_change = 0.4;
    DifferenceOptions differences{};
    TopologyThresholds thresholds{};
};

/// The reason for which the sweeps ended: the errors were below the tolerance, or max_sweeps was
/// reached first.
enum class GaussSeidelStatus { Converged, SweepLimit };

/// The result of `gauss_seidel`.
struct GaussSeidelSummary {
    GaussSeidelStatus status = GaussSeidelStatus::SweepLimit;
    int sweeps = 0;
    int t1 = 0;  // number of T1s
};

/// Runs the paper's solver (E5): sweeps over the junctions, with T1s (E7) between sweeps. A sweep
/// makes one Newton step for the block of each junction (block_step.h). The step changes the
/// position of the junction, the pressures of its bubbles, and the half angles of the outer films
/// of these bubbles. Junctions at which a film has length 0 are skipped.
///
/// Stops as soon as the errors are below the tolerance, even if a film is then shorter than its T1
/// distance. Stops after max_sweeps sweeps at the latest. Preconditions: the same as for
/// `equilibrate`.
GaussSeidelSummary gauss_seidel(Foam& foam, const GaussSeidelOptions& options);

}  // namespace foam
