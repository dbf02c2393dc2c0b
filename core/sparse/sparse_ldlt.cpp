// SPDX-License-Identifier: Apache-2.0

#include "core/sparse/sparse_ldlt.h"

#include "core/parallel/parallel_for.h"
#include "core/sparse/dissection_repair.h"
#include "core/sparse/front_factor.h"
#include "core/sparse/front_planner.h"
#include "core/sparse/front_solve.h"
#include "core/sparse/front_workspace.h"

#include <algorithm>
#include <cassert>
#include <cstdint>
#include <optional>
#include <utility>

namespace foam {

// SparseLdlt works in the usual three phases of a direct solver: analysis of the pattern, numeric
// factorization, and solution (Davis, Direct Methods for Sparse Linear Systems, 2006). For a
// quasi-definite matrix, every order of elimination gives a factor L D Lᵀ, so that no pivoting is
// needed. The proof is in Vanderbei, Symmetric quasidefinite matrices, SIAM Journal on Optimization
// 5, 1995. The order is therefore chosen to make the factor small (within a front, to make it
// accurate), and is used for all matrices of the pattern. The factorization is multifrontal (Duff,
// Reid 1983; Liu 1992): it eliminates dense fronts (front_factor.cpp), which are planned during the
// analysis (front_planner.cpp).

namespace {

// An order of elimination is repaired (dissection_repair.h) if the number of rows has changed at
// most by this factor since the order was last computed anew. The result is kept if the number of
// entries of the factor per row has grown at most by the same factor.
constexpr double kMaxGrowth = 1.1;

bool may_repair(const FactorSize& before, std::size_t rows) {
    return before.rows > 0 &&
           static_cast<double>(rows) < kMaxGrowth * static_cast<double>(before.rows) &&
           static_cast<double>(before.rows) < kMaxGrowth * static_cast<double>(rows);
}

bool is_too_large(const FactorSize& now, const FactorSize& before) {
    return static_cast<double>(now.entries) * static_cast<double>(before.rows) >
           kMaxGrowth * static_cast<double>(before.entries) * static_cast<double>(now.rows);
}

FactorSize size_of(const FrontPlan& plan) {
    return {plan.position_of_row.size(), plan.panels_size};
}

// Returns the number of threads that factor and solve a system: 1 for a small system, otherwise
// thread_count(threads), but at most kMaxWorkers.
std::size_t threads_for(const FrontPlan& plan, int threads) {
    const bool is_small = plan.position_of_row.size() < kMinParallelRows;
    return static_cast<std::size_t>(is_small ? 1 : std::min(thread_count(threads), kMaxWorkers));
}

// Sets the size of a buffer whose values are no longer needed. If the buffer has to grow, its
// memory is freed first, so that the old and the new memory do not exist at the same time.
template <class Real>
void set_size(std::vector<Real>& buffer, std::size_t size) {
    if (buffer.capacity() < size) {
        std::vector<Real>().swap(buffer);
    }
    buffer.resize(size);
}

}  // namespace

template <class Real>
LdltAnalysis SparseLdlt<Real>::analyze(const Eigen::SparseMatrix<double>& lower_pattern,
                                       std::span<const SolverNode> nodes,
                                       const Domain& domain,
                                       const LdltOptions& options,
                                       int threads) {
    const NodeGraph graph = node_graph(lower_pattern, nodes);
    const auto plan = [&] {
        return plan_fronts(
            lower_pattern, nodes, graph, dissection_, options.max_bytes / sizeof(Real));
    };
    const auto rows = static_cast<std::size_t>(lower_pattern.rows());
    // While `new_size_` is empty, no order is kept, not even after an exception.
    const FactorSize before = std::exchange(new_size_, {});
    FactorSize new_size = before;
    std::optional<FrontPlan> new_plan;
    if (options.keeps_order && may_repair(before, rows)) {
        repair(dissection_, graph, earlier_numbers(names_, nodes));
        new_plan = plan();
    }
    if (!new_plan || is_too_large(size_of(*new_plan), before)) {
        dissection_ = dissect(graph, nodes, domain, options.dissection, threads);
        new_plan = plan();
        new_size = new_plan ? size_of(*new_plan) : FactorSize{};
    }
    names_.resize(nodes.size());
    std::ranges::transform(nodes, names_.begin(), &SolverNode::name);
    new_size_ = new_size;
    if (!new_plan) {
        return LdltAnalysis::TooLarge;
    }
    plan_ = std::move(*new_plan);
    set_size(factor_, plan_.panels_size);
    set_size(workspace_, plan_.workspace_size);
    return LdltAnalysis::Planned;
}

template <class Real>
std::size_t SparseLdlt<Real>::memory_bytes(int threads) const {
    return sizeof(Real) * plan_.memory_size(threads_for(plan_, threads));
}

template <class Real>
bool SparseLdlt<Real>::factor(const Eigen::SparseMatrix<double>& lower, int threads) {
    assert(lower.isCompressed());
    assert(static_cast<std::size_t>(lower.nonZeros()) == plan_.entries.size());
    const std::size_t used_threads = threads_for(plan_, threads);
    set_size(scratch_, std::max(scratch_.size(), used_threads * plan_.scratch_size));
    const FactorMemory<Real> memory{
        {lower.valuePtr(), plan_.entries.size()}, factor_, workspace_, scratch_};
    return factor_fronts(plan_, memory, used_threads);
}

template <class Real>
Eigen::VectorXd SparseLdlt<Real>::solve(const Eigen::VectorXd& right_hand_side, int threads) const {
    const std::vector<std::uint32_t>& positions = plan_.position_of_row;
    Eigen::Vector<Real, Eigen::Dynamic> x(right_hand_side.size());
    for (std::size_t row = 0; row < positions.size(); ++row) {
        x[positions[row]] = static_cast<Real>(right_hand_side[static_cast<Eigen::Index>(row)]);
    }
    solve_fronts(plan_, factor_.data(), x, threads_for(plan_, threads));
    Eigen::VectorXd solution(right_hand_side.size());
    for (std::size_t row = 0; row < positions.size(); ++row) {
        solution[static_cast<Eigen::Index>(row)] = static_cast<double>(x[positions[row]]);
    }
    return solution;
}

template <class Real>
std::size_t SparseLdlt<Real>::nonzeros() const {
    std::size_t count = 0;
    for (const Front& front : plan_.fronts) {
        count += front.pivots * (front.pivots + 1) / 2 + front.pivots * front.border;
    }
    return count;
}

template class SparseLdlt<float>;
template class SparseLdlt<double>;

}  // namespace foam
