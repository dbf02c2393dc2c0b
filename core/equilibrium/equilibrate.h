// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/equilibrium/drift.h"
#include "core/equilibrium/equilibrium_options.h"
#include "core/foam/foam.h"

namespace foam {

/// The outcome of an equilibration.
enum class EquilibriumStatus {
    Converged,
    RoundLimit,  // no equilibrium within max_rounds rounds
    // The solver has stopped, but an error is not below the tolerance, or an inner film is at the
    // limit of its half angle (EquilibriumErrors::are_below).
    ToleranceMissed,
};

/// The work and the result of an equilibration.
struct EquilibriumSummary {
    EquilibriumStatus status = EquilibriumStatus::RoundLimit;
    int relaxations = 0;  // relaxations of the whole foam (E4), each of which may be costly
    int sweeps = 0;       // sweeps of these relaxations
    // Steps of Newton's method for the whole foam, or sweeps of Gauss-Seidel.
    int iterations = 0;
    int t1 = 0;                // number of T1s
    int t2 = 0;                // number of T2s, counted by dynamics/step; 0 after `equilibrate`
    double area_error = 0.0;   // largest area error, relative to the target area
    double angle_error = 0.0;  // largest deviation of an angle from 120 degrees, radians
    double energy = 0.0;  // film tension times the total length of all films (energy, measure.h)

    bool converged() const { return status == EquilibriumStatus::Converged; }

    /// Adds the relaxations, sweeps and iterations of an earlier summary.
    void add_work(const EquilibriumSummary& earlier) {
        relaxations += earlier.relaxations;
        sweeps += earlier.sweeps;
        iterations += earlier.iterations;
    }
};

/// Brings the foam to mechanical equilibrium (E2) at its target areas by relaxation (E4) and
/// Newton's method (E3). Makes the T1s (E7) that are due on the way to equilibrium and in
/// equilibrium. In a patch, these may leave dead slots (compact in foam.h). On a torus, the mean of
/// the resulting pressures, weighted by target area, is 0.
/// Preconditions: the network is valid; target areas are positive, and on a torus they add up to
/// its area.
EquilibriumSummary equilibrate(Foam& foam, const EquilibriumOptions& options);

/// Performs the last steps of an equilibration, which are the same for all solvers:
/// - undoes the drift of the whole foam since it had the positions `earlier` (undo_drift),
/// - centers the pressures (center_pressures),
/// - restores the full T1 distance of grown films (E7; rearm_grown_films).
/// Returns the given summary with the errors and the energy of the resulting foam. `has_stopped` is
/// true if the solver has stopped by itself; the status then becomes Converged or ToleranceMissed.
/// It is false if the limit of rounds has stopped the solver; the status is then not changed.
EquilibriumSummary conclude(Foam& foam,
                            const Positions& earlier,
                            const EquilibriumOptions& options,
                            bool has_stopped,
                            EquilibriumSummary summary);

}  // namespace foam
