// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/sparse/dissection.h"
#include "core/sparse/front_plan.h"

#include <Eigen/SparseCore>

#include <cstddef>
#include <span>
#include <vector>

namespace foam {

/// Options of SparseLdlt::analyze.
struct LdltOptions {
    DissectionOptions dissection{};
    // Largest memory for the factor and the remainders of fronts, in bytes.
    std::size_t max_bytes = std::size_t{1} << 32U;
};

/// The result of SparseLdlt::analyze.
enum class LdltAnalysis {
    Planned,
    TooLarge,  // see LdltOptions::max_bytes; nothing was planned
};

/// A direct solver for symmetric quasi-definite matrices whose rows have positions on a torus or in
/// the plane: multifrontal L D Lᵀ without pivoting, in an order found by nested dissection.
/// `threads` has the same meaning as in thread_count; the bits of the results do not depend on it.
template <class Real>
class SparseLdlt {
  public:
    /// Plans the factorization of all matrices of a pattern and allocates the planned memory.
    /// Returns TooLarge, and plans nothing, if this memory would exceed the limit of the options.
    /// The first node has the first rows, the second node the next ones, and so on. Precondition:
    /// the lower triangle is compressed and its columns are sorted.
    LdltAnalysis analyze(const Eigen::SparseMatrix<double>& lower_pattern,
                         std::span<const SolverNode> nodes,
                         const Domain& domain,
                         const LdltOptions& options = {},
                         int threads = 1);

    /// Returns the memory that `factor` uses with this many threads, in bytes.
    std::size_t memory_bytes(int threads) const;

    /// Factors a matrix of the analyzed pattern. Returns false if a pivot is zero or not finite; no
    /// factor is available then.
    bool factor(const Eigen::SparseMatrix<double>& lower, int threads);

    /// Returns the solution for a right-hand side. Precondition: a factor is available.
    Eigen::VectorXd solve(const Eigen::VectorXd& right_hand_side, int threads = 1) const;

    /// Returns the number of entries of L, including the diagonal and the zeros in dense fronts.
    std::size_t nonzeros() const;

    /// Returns the number of positive pivots of the factor, which is the number of positive
    /// eigenvalues of the matrix (Sylvester's law of inertia).
    std::size_t positive_pivots() const;

  private:
    FrontPlan plan_;
    std::vector<Real> factor_;     // D and L, sorted by front
    std::vector<Real> workspace_;  // remainders of fronts until they are added to their parents
    std::vector<Real> scratch_;
};

}  // namespace foam
