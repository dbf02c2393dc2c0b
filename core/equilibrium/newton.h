#pragma once

#include "core/equilibrium/newton_system.h"
#include "core/foam/topology_thresholds.h"

#include <vector>

namespace foam {

struct NewtonOptions {
    int max_iterations = 40;
    double force_tolerance = 1e-11;  // stops when every force is below this, in film tensions ...
    double area_tolerance = 1e-11;   // ... and every area error is, relative to the target
    double largest_move = 0.4;  // relative motion of a film's ends in an iteration, in its length
    // Stops with Slow after a step with a new factor that leaves more than this share of the
    // residual.
    double slow_ratio = 1.0;
    bool predicts_t1 = true;  // near equilibrium, from the step (closing_films)
    TopologyThresholds thresholds{};
};

enum class NewtonStatus {
    Converged,
    FilmsCollapse,  // the next step would take some films through a T1
    Slow,           // see NewtonOptions::slow_ratio
    Stalled,        // no step reduces the residual
    IterationLimit,
};

struct NewtonSummary {
    NewtonStatus status = NewtonStatus::IterationLimit;
    int iterations = 0;
    double residual = 0.0;           // larger of the largest force and area error, as above
    std::vector<FilmId> collapsing;  // with FilmsCollapse, in increasing order
};

/// Newton's method on E3, globalized: no step shortens or turns a film by more than a fraction of
/// its length, and a line search demands that the residual shrinks. A factor is kept for further
/// steps (the chord method) while they converge faster than it could be renewed.
///
/// Starts from the foam's present state; all but the system's unknowns are held. Precondition: the
/// foam has the network with which the system was started.
NewtonSummary newton(Foam& foam, NewtonSystem& system, const NewtonOptions& options);

/// The same with a system of its own.
NewtonSummary newton(Foam& foam, const Unknowns& unknowns, const NewtonOptions& options);

}  // namespace foam
