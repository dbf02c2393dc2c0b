#pragma once

#include "core/sparse/front_plan.h"

#include <Eigen/SparseCore>

#include <cstddef>
#include <span>
#include <vector>

namespace foam {

struct LdltOptions {
    DissectionOptions dissection{};
    std::size_t max_bytes = std::size_t{1} << 32U;  // of the factor and the remainders of fronts
};

enum class LdltAnalysis {
    Planned,
    TooLarge,  // see LdltOptions::max_bytes; nothing was planned
};

/// Direct solver for symmetric quasi-definite matrices over points of a torus: L D Lᵀ without
/// pivoting, multifrontal, in the order of a geometric nested dissection. The bits of its results
/// do not depend on the number of threads.
template <class Real>
class SparseLdlt {
  public:
    /// Plans for all matrices of this pattern, of which the lower triangle is given, compressed and
    /// in order. The nodes take up the rows in turn. Memory of the planned size is allocated only
    /// if it is within the limit.
    LdltAnalysis analyze(const Eigen::SparseMatrix<double>& lower_pattern,
                         std::span<const SolverNode> nodes,
                         const Domain& domain,
                         const LdltOptions& options = {},
                         int threads = 1);

    /// Returns the number of bytes that `factor` works on with this many threads.
    std::size_t memory_bytes(int threads) const;

    /// Factors a matrix of the pattern that was analyzed, on up to so many threads. Takes memory at
    /// the first call only. False where a pivot is zero or not finite: there is then nothing to
    /// solve with.
    bool factor(const Eigen::SparseMatrix<double>& lower, int threads);

    /// Needs a factor.
    Eigen::VectorXd solve(const Eigen::VectorXd& right_hand_side, int threads = 1) const;

    /// Numbers in L, the diagonal and the zeros in dense fronts included.
    std::size_t nonzeros() const;

    /// Of the factor. The matrix has as many positive eigenvalues (Sylvester).
    std::size_t positive_pivots() const;

  private:
    FrontPlan plan_;
    std::vector<Real> factor_;     // D and L, front after front
    std::vector<Real> workspace_;  // remainders of fronts until their parents take them up
    std::vector<Real> scratch_;
};

}  // namespace foam
