#pragma once

#include "core/reference/junction_block.h"

namespace foam {

/// Central differences whose step is halved until they converge (paper 4.1). Unknowns and
/// constraints have no units (JunctionBlock).
struct DifferenceOptions {
    double first_step = 1e-3;
    double threshold = 1e-6;  // stops when a halving changes no entry by this or more
    int max_halvings = 10;    // or then: slopes jump where half angles reach their limit
};

/// Returns the derivatives of the constraints' errors by the unknowns, at no change. Precondition:
/// the block is not degenerate.
BlockMatrix block_slopes(const JunctionBlock& block, const DifferenceOptions& options);

/// Returns the Newton step of the block (paper eq. 10 and 11), the smallest one if the slopes are
/// singular. Precondition: the block is not degenerate.
BlockVector block_step(const JunctionBlock& block, const DifferenceOptions& options);

}  // namespace foam
