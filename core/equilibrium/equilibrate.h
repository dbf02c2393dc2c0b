// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/equilibrium/drift.h"
#include "core/equilibrium/equilibrium_options.h"
#include "core/foam/foam.h"

namespace foam {

/// How an equilibration ended.
enum class EquilibriumStatus {
    Converged,
    RoundLimit,       // no equilibrium within max_rounds rounds
    ToleranceMissed,  // the solver has stopped, but an error is above the tolerance
};

/// The work and the result of an equilibration.
struct EquilibriumSummary {
    EquilibriumStatus status = EquilibriumStatus::RoundLimit;
    int sweeps = 0;  // relaxation sweeps over the whole foam
    // Steps of Newton's method for the whole foam, or sweeps of Gauss-Seidel.
    int iterations = 0;
    int t1 = 0;
    int t2 = 0;                // counted by dynamics/step; 0 after `equilibrate`
    double area_error = 0.0;   // largest, relative to the target area
    double angle_error = 0.0;  // largest, radians
    double energy = 0.0;

    bool converged() const { return status == EquilibriumStatus::Converged; }
};

/// Brings the foam to mechanical equilibrium (E2) at its target areas by Newton's method (E3).
/// Makes a T1 (E7) where a film collapses and where a film is shorter than its T1 distance in
/// equilibrium. On a torus, the resulting pressures have an area-weighted mean of 0. Preconditions:
/// the network is valid; target areas are positive, and on a torus they add up to its area.
EquilibriumSummary equilibrate(Foam& foam, const EquilibriumOptions& options);

/// Ends an equilibration by any solver: undoes the drift from the positions `before`, centers the
/// pressures, rearms grown films, and writes the errors, the energy and the status to the summary.
/// `is_at_rest` is true if the solver has stopped by itself and no T1 is due. Otherwise the status
/// is not changed.
EquilibriumSummary conclude(Foam& foam,
                            const Positions& before,
                            const EquilibriumOptions& options,
                            bool is_at_rest,
                            EquilibriumSummary summary);

}  // namespace foam
