// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/equilibrium/equilibrate.h"

namespace foam {

/// The solvers that can bring a foam to equilibrium.
enum class Solver {
    Newton,       // Newton's method for the whole foam (E3; core/equilibrium)
    GaussSeidel,  // the paper's solver, one block after another (E5; core/reference)
    // The paper's solver, all blocks of a color at once. Blocks of one color share no bubble except
    // the ghost (core/reference).
    ColoredGaussSeidel,
};

/// Brings the foam to mechanical equilibrium with the given solver. The summary tells whether it
/// converged.
EquilibriumSummary equilibrate_with(Solver solver, Foam& foam, const EquilibriumOptions& options);

}  // namespace foam
