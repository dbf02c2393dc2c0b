// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/equilibrium/newton_system.h"
#include "core/foam/topology_thresholds.h"

#include <vector>

namespace foam {

/// Options of `newton`.
struct NewtonOptions {
    int max_iterations = 40;
    // Convergence: every force is below this, in film tensions, ...
    double force_tolerance = 1e-11;
    // ... and every area error is below this, relative to the target area.
    double area_tolerance = 1e-11;
    // Largest relative motion of the two ends of a film in one iteration, in film lengths.
    double largest_move = 0.4;
    // Stops with Slow after a step with a new factor that leaves more than this share of the norm
    // of the residual.
    double slow_ratio = 1.0;
    // Near equilibrium, T1s are predicted from the step (closing_films).
    bool predicts_t1 = true;
    TopologyThresholds thresholds{};
};

/// How Newton's method ended.
enum class NewtonStatus {
    Converged,
    FilmsCollapse,  // the next step would take films through a T1
    Slow,           // see NewtonOptions::slow_ratio
    Stalled,        // no step reduces the residual
    IterationLimit,
};

/// The result of `newton`.
struct NewtonSummary {
    NewtonStatus status = NewtonStatus::IterationLimit;
    int iterations = 0;
    // The larger of the largest force and the largest area error, in the units of the tolerances.
    double residual = 0.0;
    std::vector<FilmId> collapsing;  // films of FilmsCollapse, in increasing order
};

/// Runs Newton's method on E3 from the present state of the foam, with everything held except the
/// unknowns of the system. It is globalized: a step is limited so that it shortens or turns a film
/// by at most a fraction of its length, and a line search requires the residual to decrease. A
/// factor is kept for further steps (the chord method) while they converge faster than a new factor
/// would pay for itself.
///
/// Precondition: the foam has the network with which the system was started.
NewtonSummary newton(Foam& foam, NewtonSystem& system, const NewtonOptions& options);

/// Runs Newton's method with a NewtonSystem of its own, on all hardware threads.
NewtonSummary newton(Foam& foam, const Unknowns& unknowns, const NewtonOptions& options);

}  // namespace foam
