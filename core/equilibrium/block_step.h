#pragma once

#include "core/equilibrium/junction_block.h"

namespace foam {

/// Central differences whose step is halved until they settle (paper 4.1). Of unknowns and
/// constraints without units, see JunctionBlock.
struct DifferenceOptions {
    double first_step = 1e-3;
    double threshold = 1e-6;  // stops when a halving changes no entry by this or more
    int max_halvings = 10;    // or then: where a half angle comes to its limit, slopes jump
};

/// Derivatives of what the constraints lack by the unknowns, at no change. Precondition: the block
/// is not degenerate.
BlockMatrix block_slopes(const JunctionBlock& block, const DifferenceOptions& options);

/// The Newton step of the block (paper eq. 10 and 11), the smallest one where the slopes are
/// singular. Precondition as above.
BlockVector block_step(const JunctionBlock& block, const DifferenceOptions& options);

}  // namespace foam
