#pragma once

#include "core/equilibrium/topology_thresholds.h"
#include "core/equilibrium/unknowns.h"

#include <vector>

namespace foam {

struct NewtonOptions {
    int max_iterations = 40;
    double force_tolerance = 1e-11;  // stops when every force is below this, in film tensions ...
    double area_tolerance = 1e-11;   // ... and every area error is, relative to the target
    double largest_move = 0.4;       // of a junction in an iteration, in its shortest films
    TopologyThresholds thresholds{};
    int threads = 0;  // of the linear solver, same bits for any number; 0: as many as run at once
};

enum class NewtonStatus {
    Converged,
    FilmsCollapse,  // the step would shorten some films through zero: they await a T1
    Stalled,        // no step reduces the residual
    IterationLimit,
};

struct NewtonSummary {
    NewtonStatus status = NewtonStatus::IterationLimit;
    int iterations = 0;
    double residual = 0.0;           // larger of the largest force and area error, as above
    std::vector<FilmId> collapsing;  // in increasing order
};

/// Newton's method on E3, globalized: each junction moves at most a fraction of its shortest film,
/// and a line search demands that the residual shrinks. Works on a few unknowns as on all.
NewtonSummary newton(Foam& foam, const Unknowns& unknowns, const NewtonOptions& options);

}  // namespace foam
