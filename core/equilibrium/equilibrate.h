#pragma once

#include "core/equilibrium/drift.h"
#include "core/equilibrium/equilibrium_options.h"
#include "core/foam/foam.h"

namespace foam {

enum class EquilibriumStatus {
    Converged,
    RoundLimit,       // T1s and relaxation led to no equilibrium in max_rounds
    ToleranceMissed,  // the solver has come to its end, but an error is above the
                      // tolerance
};

/// How a foam came to equilibrium, and how near.
struct EquilibriumSummary {
    EquilibriumStatus status = EquilibriumStatus::RoundLimit;
    int sweeps = 0;      // of relaxation of the whole foam
    int iterations = 0;  // of Newton's method for the whole foam, or sweeps of Gauss-Seidel
    int t1 = 0;
    int t2 = 0;
    double area_error = 0.0;   // largest, relative
    double angle_error = 0.0;  // largest, radians
    double energy = 0.0;

    bool converged() const { return status == EquilibriumStatus::Converged; }
};

/// Brings the foam to mechanical equilibrium (E2) at its target areas by Newton's method (E3), with
/// T1 (E7) where a film collapses and where one rests below the T1 distance. On a torus, pressures
/// come out with an area-weighted mean of 0. Preconditions: a valid network; positive targets,
/// which on a torus add up to its area.
EquilibriumSummary equilibrate(Foam& foam, const EquilibriumOptions& options);

/// Ends an equilibration, whichever solver it used: moves the foam back by its drift from the
/// positions `before`, centers the pressures, rearms grown films, and measures the errors and the
/// energy for the summary. `is_at_rest`: the solver has come to its end, and no T1 is due.
EquilibriumSummary conclude(Foam& foam,
                            const Positions& before,
                            const EquilibriumOptions& options,
                            bool is_at_rest,
                            EquilibriumSummary summary);

}  // namespace foam
