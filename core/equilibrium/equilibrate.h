#pragma once

#include "core/equilibrium/gauss_seidel.h"
#include "core/equilibrium/newton.h"
#include "core/foam/topology_thresholds.h"
#include "core/foam/foam.h"

namespace foam {

/// What solves for equilibrium.
enum class Solver {
    Newton,              // of the whole foam (E3)
    GaussSeidel,         // block by block, the paper's own (E5)
    ColoredGaussSeidel,  // the same, many blocks at once
};

struct EquilibriumOptions {
    Solver solver = Solver::Newton;
    TopologyThresholds thresholds{};
    // Succeeds when the largest area and angle errors are below this. Gauss-Seidel also stops
    // there; below 1e-4 it takes long.
    double tolerance = 1e-9;
    bool relaxes_first = true;   // for a foam that is far from equilibrium (E4)
    int relaxation_sweeps = 60;  // at first, and where Newton's method stalls
    int threads = 0;             // as in NewtonOptions
    int max_rounds = 100;        // of the solver, each ended by T1s or by relaxation
};

enum class EquilibriumStatus {
    Converged,
    RoundLimit,       // T1s and relaxation led to no equilibrium in max_rounds
    ToleranceMissed,  // Newton's method stands still, or Gauss-Seidel has used up its sweeps, but
                      // an error is above the tolerance
};

/// How a foam came to equilibrium, and how near.
struct EquilibriumSummary {
    EquilibriumStatus status = EquilibriumStatus::RoundLimit;
    int sweeps = 0;      // of relaxation
    int iterations = 0;  // of Newton's method, or sweeps of Gauss-Seidel
    int t1 = 0;
    int t2 = 0;
    double area_error = 0.0;   // largest, relative
    double angle_error = 0.0;  // largest, radians
    double energy = 0.0;

    bool converged() const { return status == EquilibriumStatus::Converged; }
};

/// Brings the foam to mechanical equilibrium (E2) at its target areas, with T1 (E7) where a film
/// collapses and where one rests below the T1 distance. Pressures come out with an area-weighted
/// mean of 0. Preconditions: a valid network, positive targets that on a torus add up to its area.
EquilibriumSummary equilibrate(Foam& foam, const EquilibriumOptions& options);

}  // namespace foam
