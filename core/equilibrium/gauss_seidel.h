#pragma once

#include "core/equilibrium/block_step.h"
#include "core/foam/topology_thresholds.h"
#include "core/foam/foam.h"

namespace foam {

/// In which order a sweep goes over the junctions.
enum class SweepOrder {
    Sequential,  // by id, each block at what the one before has left (the paper's)
    Colored,     // colour by colour, all blocks of a colour at once (its future work)
};

struct GaussSeidelOptions {
    double tolerance = 1e-4;  // converged when the largest area and angle errors are below this
    int max_sweeps = 10000;
    SweepOrder order = SweepOrder::Sequential;
    int threads = 0;  // of colored sweeps, same bits for any number; 0: as many as run at once
    double largest_change = 0.4;  // of a block in a sweep: of a pressure in film tensions over the
                                  // root of its bubble's area, of a junction in its shortest film,
                                  // of an outer film's half angle in radians
    DifferenceOptions differences{};
    TopologyThresholds thresholds{};
};

enum class GaussSeidelStatus { Converged, SweepLimit };

struct GaussSeidelSummary {
    GaussSeidelStatus status = GaussSeidelStatus::SweepLimit;
    int sweeps = 0;
    int t1 = 0;
};

/// The paper's own solver (E5): sweeps over the junctions, each moved together with the pressures
/// of its bubbles by the Newton step of its block (block_step.h), with T1 (E7) between sweeps.
///
/// It does not look for a T1 where it has converged: a film may rest below its T1 distance then.
/// Preconditions as of `equilibrate`.
GaussSeidelSummary gauss_seidel(Foam& foam, const GaussSeidelOptions& options);

}  // namespace foam
