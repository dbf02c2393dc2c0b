// SPDX-License-Identifier: Apache-2.0

#include "core/reference/block_step.h"

#include <Eigen/SVD>

#include <cmath>
#include <numbers>

namespace foam {

// The Newton step of one block, computed as in the paper (4.1). The Jacobian of eq. 11 is computed
// column by column, by central differences whose step is halved until they converge. The linear
// system is solved by singular value decomposition, which also has a solution for singular blocks.

namespace {

using Eigen::Index;

// Singular values below this share of the largest count as zero, since the differences are not more
// accurate. The unknowns are scaled such that the singular values of a regular block are well above
// this share.
constexpr double kSingular = 1e-6;

BlockVector central_difference(const JunctionBlock& block, Index unknown, double step) {
    BlockVector change = BlockVector::Zero(block.size());
    change[unknown] = step;
    BlockVector difference = block.constraint_errors(change);
    change[unknown] = -step;
    difference -= block.constraint_errors(change);
    for (double& turn : difference.tail<2>()) {
        turn = std::remainder(turn, 2.0 * std::numbers::pi);
    }
    return difference / (2.0 * step);
}

BlockVector slopes_by(const JunctionBlock& block, Index unknown, const DifferenceOptions& options) {
    double step = options.first_step;
    BlockVector slopes = central_difference(block, unknown, step);
    for (int halvings = 0; halvings < options.max_halvings; ++halvings) {
        step *= 0.5;
        const BlockVector finer = central_difference(block, unknown, step);
        const double change = (finer - slopes).cwiseAbs().maxCoeff();
        slopes = finer;
        if (change < options.threshold) {
            break;
        }
    }
    return slopes;
}

}  // namespace

BlockMatrix block_slopes(const JunctionBlock& block, const DifferenceOptions& options) {
    BlockMatrix slopes(block.size(), block.size());
    for (Index unknown = 0; unknown < block.size(); ++unknown) {
        slopes.col(unknown) = slopes_by(block, unknown, options);
    }
    return slopes;
}

BlockVector block_step(const JunctionBlock& block, const DifferenceOptions& options) {
    Eigen::JacobiSVD<BlockMatrix> svd(block_slopes(block, options),
                                      Eigen::ComputeFullU | Eigen::ComputeFullV);
    svd.setThreshold(kSingular);
    return -svd.solve(block.constraint_errors(BlockVector::Zero(block.size())));
}

}  // namespace foam
