// SPDX-License-Identifier: Apache-2.0

#include "core/reference/block_step.h"

#include <Eigen/SVD>

#include <cmath>
#include <numbers>

namespace foam {

// The Newton step of one block, computed as in the paper (section 4.1). The Jacobian of eq. 11 is
// computed column by column, by central differences. The step of the differences is halved until
// the column converges. The linear system is solved by singular value decomposition, which also
// gives a solution if the Jacobian is singular.

namespace {

using Eigen::Index;

// Singular values below this fraction of the largest one count as zero, since the derivatives are
// only accurate to about 1e-6 (DifferenceOptions::threshold). The unknowns are scaled so that the
// singular values of a regular block are well above this fraction.
constexpr double kSingular = 1e-6;

BlockVector central_difference(const JunctionBlock& block, Index unknown, double step) {
    BlockVector change = BlockVector::Zero(block.size());
    change[unknown] = step;
    BlockVector difference = block.constraint_errors(change);
    change[unknown] = -step;
    difference -= block.constraint_errors(change);
    // The last two constraints are angles, which are known only up to multiples of 2 pi.
    for (double& turn : difference.tail<2>()) {
        turn = std::remainder(turn, 2.0 * std::numbers::pi);
    }
    return difference / (2.0 * step);
}

// Returns the derivatives of the errors of the constraints with respect to one unknown.
BlockVector jacobian_column(const JunctionBlock& block,
                            Index unknown,
                            const DifferenceOptions& options) {
    double step = options.first_step;
    BlockVector column = central_difference(block, unknown, step);
    for (int halvings = 0; halvings < options.max_halvings; ++halvings) {
        step *= 0.5;
        const BlockVector finer = central_difference(block, unknown, step);
        const double change = (finer - column).cwiseAbs().maxCoeff();
        column = finer;
        if (change < options.threshold) {
            break;
        }
    }
    return column;
}

}  // namespace

BlockMatrix block_jacobian(const JunctionBlock& block, const DifferenceOptions& options) {
    BlockMatrix jacobian(block.size(), block.size());
    for (Index unknown = 0; unknown < block.size(); ++unknown) {
        jacobian.col(unknown) = jacobian_column(block, unknown, options);
    }
    return jacobian;
}

BlockVector block_step(const JunctionBlock& block, const DifferenceOptions& options) {
    Eigen::JacobiSVD<BlockMatrix> svd(block_jacobian(block, options),
                                      Eigen::ComputeFullU | Eigen::ComputeFullV);
    svd.setThreshold(kSingular);
    return -svd.solve(block.constraint_errors(BlockVector::Zero(block.size())));
}

}  // namespace foam
