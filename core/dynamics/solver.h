// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/equilibrium/equilibrate.h"

namespace foam {

/// The solvers that can bring a foam to equilibrium.
enum class Solver {
    Newton,       // Newton's method for the whole foam (E3; core/equilibrium)
    GaussSeidel,  // the paper's solver, one block after another (E5; core/reference)
    // The paper's solver, with colored blocks (core/reference). Blocks that share a bubble other
    // than the ghost have different colors. All blocks of one color are solved at once.
    ColoredGaussSeidel,
};

/// Brings the foam to mechanical equilibrium with the given solver. The summary tells whether it
/// converged.
EquilibriumSummary equilibrate_with(Solver solver, Foam& foam, const EquilibriumOptions& options);

}  // namespace foam
