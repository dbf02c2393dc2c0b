#pragma once

#include "core/foam/foam.h"
#include "core/foam/topology_thresholds.h"
#include "core/reference/block_step.h"

namespace foam {

/// The order in which a sweep visits the junctions.
enum class SweepOrder {
    Sequential,  // by id, each block from where the one before has left the foam (paper)
    Colored,     // color by color, all blocks of a color at once (paper, future work)
};

struct GaussSeidelOptions {
    double tolerance = 1e-4;  // converged when the largest area and angle errors are below this
    int max_sweeps = 10000;
    SweepOrder order = SweepOrder::Sequential;
    int threads = 0;  // of colored sweeps, as in parallel_for; same bits for any number
    // Of a block in a sweep: of a pressure in film tensions over the root of its bubble's area, of
    // a junction in lengths of its shortest film, of an outer film's half angle in radians.
    double largest_change = 0.4;
    DifferenceOptions differences{};
    TopologyThresholds thresholds{};
};

enum class GaussSeidelStatus { Converged, SweepLimit };

struct GaussSeidelSummary {
    GaussSeidelStatus status = GaussSeidelStatus::SweepLimit;
    int sweeps = 0;
    int t1 = 0;
};

/// Runs the paper's solver (E5): sweeps over the junctions, each moved together with the pressures
/// of its bubbles by the Newton step of its block (block_step.h), with T1s (E7) between sweeps.
///
/// Stops as soon as the errors are below the tolerance, even if a film rests below its T1 distance
/// then. Preconditions: as of `equilibrate`.
GaussSeidelSummary gauss_seidel(Foam& foam, const GaussSeidelOptions& options);

}  // namespace foam
