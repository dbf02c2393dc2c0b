// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/sparse/dissection.h"
#include "core/sparse/front_plan.h"

#include <Eigen/SparseCore>

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace foam {

/// Options of SparseLdlt::analyze.
struct LdltOptions {
    DissectionOptions dissection{};
    // Largest memory for the factor and the update matrices of fronts, in bytes.
    std::size_t max_bytes = std::size_t{1} << 32U;
    // If true, the order of elimination of the last call of `analyze` is repaired
    // (dissection_repair.h) instead of computed anew. This is much faster if only a few nodes and
    // edges of the graph of nodes have changed. Nodes of the last call are found by their names
    // (earlier_numbers), which should differ from each other. The order is computed anew in any of
    // these cases:
    // - `analyze` has not been called before, or its last call returned TooLarge.
    // - The matrix has more than 1.1 times as many rows as the matrix for which the order was last
    //   computed anew, or fewer than 1 / 1.1 times as many.
    // - With the repaired order, the memory would exceed `max_bytes`.
    // - With the repaired order, the factor would have more than 1.1 times as many entries per row
    //   as with the order that was last computed anew.
    bool keeps_order = false;
};

/// The result of SparseLdlt::analyze.
enum class LdltAnalysis {
    Planned,
    TooLarge,  // the memory would exceed LdltOptions::max_bytes; nothing was planned
};

/// The numbers of rows and of stored entries of a factor. Both are 0 if there is none.
struct FactorSize {
    std::size_t rows = 0;
    std::size_t entries = 0;
};

/// A direct solver for symmetric quasi-definite matrices whose rows have positions on a torus or in
/// the plane. The method is multifrontal L D Lᵀ without pivoting; nested dissection finds the order
/// of elimination. `threads` has the same meaning as in thread_count; the bits of the results do
/// not depend on it.
template <class Real>
class SparseLdlt {
  public:
    /// Plans the factorization of all matrices of a pattern, and allocates memory for the factor
    /// and the update matrices of fronts. Returns TooLarge, and plans nothing, if this memory would
    /// exceed LdltOptions::max_bytes. `nodes` are the nodes (SolverNode) of the matrix, and
    /// `domain` is the torus or plane of their positions. The first node has the first rows of the
    /// matrix, the second node has the next rows, and so on. Preconditions: there is at least one
    /// node; the lower triangle is compressed, and the entries of each column are sorted by row.
    LdltAnalysis analyze(const Eigen::SparseMatrix<double>& lower_pattern,
                         std::span<const SolverNode> nodes,
                         const Domain& domain,
                         const LdltOptions& options = {},
                         int threads = 1);

    /// Returns the memory that `factor` uses with the given number of threads, in bytes: the
    /// factor, the update matrices and the working memory of the threads. Precondition: `analyze`
    /// has returned Planned.
    std::size_t memory_bytes(int threads) const;

    /// Factors a matrix of the analyzed pattern. `lower` is its lower triangle, compressed. Returns
    /// false if a pivot is zero or not finite; no factor is available then. Precondition: `analyze`
    /// has returned Planned.
    bool factor(const Eigen::SparseMatrix<double>& lower, int threads);

    /// Returns the solution of the linear system for a right-hand side. Precondition: a factor is
    /// available.
    Eigen::VectorXd solve(const Eigen::VectorXd& right_hand_side, int threads = 1) const;

    /// Returns the number of entries of L, including the diagonal and the zeros that dense fronts
    /// store. Precondition: `analyze` has returned Planned.
    std::size_t nonzeros() const;

  private:
    Dissection dissection_;
    std::vector<std::uint64_t> names_;  // of the nodes of the dissection
    FactorSize new_size_;               // of the matrix for which the order was last computed anew
    FrontPlan plan_;
    std::vector<Real> factor_;     // D and L, sorted by front
    std::vector<Real> workspace_;  // update matrices until they are added to the parent fronts
    std::vector<Real> scratch_;    // working memory of all threads
};

}  // namespace foam
