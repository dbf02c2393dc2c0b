// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/reference/junction_block.h"

namespace foam {

/// Parameters of the central differences (paper section 4.1). The step of a difference quotient is
/// halved until the quotient converges. Steps and derivatives are dimensionless, because unknowns
/// and constraints are dimensionless (JunctionBlock).
struct DifferenceOptions {
    double first_step = 1e-3;
    double threshold = 1e-6;  // converged if a halving changes every derivative by less than this
    // Largest number of halvings. It is reached where the derivatives jump, because a half angle is
    // at its limit.
    int max_halvings = 10;
};

/// Returns the Jacobian matrix in the present state: the derivatives of the errors of the
/// constraints (rows) with respect to the unknowns (columns). Precondition: the block is not
/// degenerate.
BlockMatrix block_jacobian(const JunctionBlock& block, const DifferenceOptions& options);

/// Returns the Newton step of the block (paper eq. 10 and 11). If the Jacobian matrix is singular,
/// the step is the least-squares solution of minimum norm. Precondition: the block is not
/// degenerate.
BlockVector block_step(const JunctionBlock& block, const DifferenceOptions& options);

}  // namespace foam
