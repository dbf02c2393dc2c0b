// SPDX-License-Identifier: Apache-2.0

#include "tests/bench/sparse_solvers/peers.h"

#include <cholmod.h>
#include <fmt/core.h>

#include <stdexcept>
#include <utility>

namespace foam::bench {

namespace {

// Returns a view of the lower triangle of a symmetric matrix for CHOLMOD. The view uses Eigen's
// memory, to which CHOLMOD does not write.
cholmod_sparse view(const Eigen::SparseMatrix<double>& lower) {
    cholmod_sparse sparse{};
    sparse.nrow = static_cast<std::size_t>(lower.rows());
    sparse.ncol = sparse.nrow;
    sparse.nzmax = static_cast<std::size_t>(lower.nonZeros());
    sparse.p = const_cast<int*>(lower.outerIndexPtr());
    sparse.i = const_cast<int*>(lower.innerIndexPtr());
    sparse.x = const_cast<double*>(lower.valuePtr());
    sparse.stype = -1;
    sparse.itype = CHOLMOD_INT;
    sparse.xtype = CHOLMOD_REAL;
    sparse.sorted = 1;
    sparse.packed = 1;
    return sparse;
}

class Cholmod {
  public:
    Cholmod(int supernodal, int ordering) {
        cholmod_start(&common_);
        common_.supernodal = supernodal;
        common_.nmethods = 1;
        common_.method[0].ordering = ordering;
    }
    Cholmod(const Cholmod&) = delete;
    Cholmod& operator=(const Cholmod&) = delete;
    ~Cholmod() {
        cholmod_free_factor(&factor_, &common_);
        cholmod_finish(&common_);
    }

    Result run(const Eigen::SparseMatrix<double>& lower, Eigen::VectorXd b) {
        cholmod_sparse matrix = view(lower);
        Result result;
        result.analysis_seconds = min_seconds([&] {
            cholmod_free_factor(&factor_, &common_);
            factor_ = cholmod_analyze(&matrix, &common_);
        });
        demand_success();
        common_.memory_usage = common_.memory_inuse;  // drops the peak of the analysis
        result.factor_seconds = min_seconds([&] { cholmod_factorize(&matrix, factor_, &common_); });
        demand_success();
        result.bytes = static_cast<double>(common_.memory_usage);
        result.numbers =
            static_cast<double>(factor_->is_super != 0 ? factor_->xsize : factor_->nzmax);
        result.positions =
            inverse(Permutation::Map(static_cast<const int*>(factor_->Perm), b.size()));
        Eigen::VectorXd x;
        result.solve_seconds = min_seconds([&] { x = solve(b); });
        result.residual = residual(lower, x, b);
        return result;
    }

  private:
    Eigen::VectorXd solve(Eigen::VectorXd& right_side) {
        cholmod_dense b{};
        b.nrow = b.nzmax = b.d = static_cast<std::size_t>(right_side.size());
        b.ncol = 1;
        b.x = right_side.data();
        b.xtype = CHOLMOD_REAL;
        cholmod_dense* x = cholmod_solve(CHOLMOD_A, factor_, &b, &common_);
        demand_success();
        Eigen::VectorXd solution =
            Eigen::VectorXd::Map(static_cast<double*>(x->x), right_side.size());
        cholmod_free_dense(&x, &common_);
        return solution;
    }

    void demand_success() const {
        if (common_.status != CHOLMOD_OK) {
            throw std::runtime_error(fmt::format("CHOLMOD failed with status {}", common_.status));
        }
    }

    cholmod_common common_{};
    cholmod_factor* factor_ = nullptr;
};

}  // namespace

std::vector<Result> cholmod_results(const System& system) {
    const Eigen::SparseMatrix<double> positive = dominant(system.lower);
    std::vector<Result> results;
    for (const auto& [ordering, name] : {std::pair{CHOLMOD_AMD, "AMD"}, {CHOLMOD_METIS, "METIS"}}) {
        results.push_back(
            Cholmod(CHOLMOD_SIMPLICIAL, ordering).run(system.lower, system.right_side));
        results.back().solver = fmt::format("CHOLMOD simplicial LDLᵀ, {}", name);
        results.push_back(Cholmod(CHOLMOD_SUPERNODAL, ordering).run(positive, system.right_side));
        results.back().solver = fmt::format("CHOLMOD supernodal LLᵀ (1), {}", name);
    }
    return results;
}

}  // namespace foam::bench
