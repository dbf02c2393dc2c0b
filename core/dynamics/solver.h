// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/equilibrium/equilibrate.h"

namespace foam {

/// The solver that brings a foam to equilibrium.
enum class Solver {
    Newton,              // Newton's method for the whole foam (E3; core/equilibrium)
    GaussSeidel,         // the paper's solver, block by block (E5; core/reference)
    ColoredGaussSeidel,  // the paper's solver, many independent blocks at once
};

/// Brings the foam to mechanical equilibrium with the given solver.
EquilibriumSummary equilibrate_with(Solver solver, Foam& foam, const EquilibriumOptions& options);

}  // namespace foam
