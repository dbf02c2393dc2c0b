#include "core/equilibrium/sparse_ldlt.h"

#include "core/equilibrium/front_workspace.h"
#include "core/equilibrium/partial_ldlt.h"

#include <algorithm>
#include <atomic>
#include <cassert>
#include <thread>

namespace foam {

namespace {

constexpr std::size_t kFewRows = 3000;  // factored before a thread would have started

using Eigen::Index;

Index signed_size(std::size_t size) {
    return static_cast<Index>(size);
}

// What one call of SparseLdlt::factor works on.
struct Memory {
    std::span<const double> values;  // of the matrix
    std::span<double> factor;
    std::span<double> workspace;
    std::span<double> scratch;
    std::size_t scratch_per_thread = 0;
};

class Factorization {
  public:
    Factorization(const FrontPlan& plan, const Memory& memory) : plan_(plan), memory_(memory) {}

    bool run(std::size_t threads) {
        factor_subtree(plan_.fronts.size() - 1, 0, threads);
        return !failed_;
    }

  private:
    // On the given threads, of which the first is the present one.
    void factor_subtree(std::size_t root, std::size_t first_thread, std::size_t threads) {
        const Front& front = plan_.fronts[root];
        if (threads == 1 || !front.may_fork) {
            for (std::size_t k = front.first_descendant; k <= root; ++k) {
                factor_front(plan_.fronts[k], first_thread);
            }
            return;
        }
        {
            const std::size_t half = threads / 2;
            const std::jthread left([&] { factor_subtree(front.left, first_thread, half); });
            factor_subtree(front.right, first_thread + half, threads - half);
        }
        factor_front(front, first_thread);
    }

    void factor_front(const Front& front, std::size_t thread) {
        if (failed_) {
            return;
        }
        assemble(front);
        double* scratch = memory_.scratch.data() + thread * memory_.scratch_per_thread;
        const DenseView panel(memory_.factor.data() + front.panel_begin,
                              signed_size(front.rows()),
                              signed_size(front.pivots));
        const DenseView remainder(memory_.workspace.data() + front.remainder_begin,
                                  signed_size(front.border),
                                  signed_size(front.border));
        if (factor_panel(panel, scratch)) {
            update_remainder(panel, remainder, scratch);
        } else {
            failed_ = true;
        }
    }

    // Sums up the matrix' own numbers and the remainders of the front's children.
    void assemble(const Front& front) {
        const auto panel = memory_.factor.subspan(front.panel_begin, front.pivots * front.rows());
        const auto remainder =
            memory_.workspace.subspan(front.remainder_begin, front.border * front.border);
        std::fill(panel.begin(), panel.end(), 0.0);
        std::fill(remainder.begin(), remainder.end(), 0.0);
        for (std::size_t k = front.entries_begin; k < front.entries_end; ++k) {
            const FrontPlan::Entry& entry = plan_.entries[k];
            panel[entry.place] = memory_.values[entry.source];
        }
        if (!front.is_leaf()) {
            take_up(plan_.fronts[front.left], front);
            take_up(plan_.fronts[front.right], front);
        }
    }

    void take_up(const Front& child, const Front& front) {
        const std::span<const std::uint32_t> places = plan_.places_of_border(child);
        const double* source = memory_.workspace.data() + child.remainder_begin;
        for (std::size_t column = 0; column < child.border; ++column) {
            const std::size_t place = places[column];
            const bool in_panel = place < front.pivots;
            double* target = in_panel
                                 ? memory_.factor.data() + front.panel_begin + place * front.rows()
                                 : memory_.workspace.data() + front.remainder_begin +
                                       (place - front.pivots) * front.border;
            const std::size_t first_place = in_panel ? 0 : front.pivots;
            for (std::size_t row = column; row < child.border; ++row) {
                target[places[row] - first_place] += source[row];
            }
            source += child.border;
        }
    }

    const FrontPlan& plan_;
    Memory memory_;
    std::atomic<bool> failed_ = false;
};

// One front's part in the solution, in the order of elimination.
class FrontSolve {
  public:
    FrontSolve(const FrontPlan& plan, const Front& front, const double* factor)
        : pivots_(signed_size(front.pivots)),
          first_row_(signed_size(front.first_row)),
          border_(plan.rows_of_border(front)),
          top_(factor + front.panel_begin, pivots_, pivots_, stride(front)),
          below_(top_.data() + pivots_, signed_size(front.border), pivots_, stride(front)) {}

    void forward(Eigen::VectorXd& x, Eigen::VectorXd& scratch) const {
        auto own = x.segment(first_row_, pivots_);
        auto share = scratch.head(signed_size(border_.size()));
        for (Index column = 0; column < pivots_; ++column) {
            const Index later = pivots_ - column - 1;
            own.tail(later) -= own[column] * top_.col(column).tail(later);
        }
        share.noalias() = below_ * own;
        for (std::size_t k = 0; k < border_.size(); ++k) {
            x[border_[k]] -= share[signed_size(k)];
        }
        own.array() /= top_.diagonal().array();
    }

    void backward(Eigen::VectorXd& x, Eigen::VectorXd& scratch) const {
        auto own = x.segment(first_row_, pivots_);
        auto known = scratch.head(signed_size(border_.size()));
        for (std::size_t k = 0; k < border_.size(); ++k) {
            known[signed_size(k)] = x[border_[k]];
        }
        own.noalias() -= below_.transpose() * known;
        for (Index column = pivots_ - 1; column >= 0; --column) {
            const Index later = pivots_ - column - 1;
            own[column] -= top_.col(column).tail(later).dot(own.tail(later));
        }
    }

  private:
    using Window = Eigen::Map<const Eigen::MatrixXd, 0, Eigen::OuterStride<>>;

    static Eigen::OuterStride<> stride(const Front& front) {
        return Eigen::OuterStride<>(signed_size(front.rows()));
    }

    Index pivots_;
    Index first_row_;
    std::span<const std::uint32_t> border_;
    Window top_;    // D and the pivots' part of L
    Window below_;  // the border's part of L
};

}  // namespace

void SparseLdlt::analyze(const Eigen::SparseMatrix<double>& lower_pattern,
                         std::span<const SolverNode> nodes,
                         const Torus& torus,
                         const DissectionOptions& options) {
    plan_ = plan_fronts(lower_pattern, nodes, torus, options);
    factor_.resize(plan_.panels_size);
    workspace_.resize(plan_.workspace_size);
}

bool SparseLdlt::factor(const Eigen::SparseMatrix<double>& lower, int threads) {
    assert(lower.isCompressed());
    assert(static_cast<std::size_t>(lower.nonZeros()) == plan_.entries.size());
    const bool is_small = plan_.elimination.size() < kFewRows;
    const auto used = static_cast<std::size_t>(is_small ? 1 : std::clamp(threads, 1, kMostThreads));
    scratch_.resize(std::max(scratch_.size(), used * plan_.scratch_size));
    const Memory memory{{lower.valuePtr(), plan_.entries.size()},
                        factor_,
                        workspace_,
                        scratch_,
                        plan_.scratch_size};
    return Factorization(plan_, memory).run(used);
}

Eigen::VectorXd SparseLdlt::solve(const Eigen::VectorXd& right_hand_side) const {
    const auto& turns = plan_.elimination;
    Eigen::VectorXd x(right_hand_side.size());
    Eigen::VectorXd scratch(signed_size(plan_.largest_border));
    for (std::size_t row = 0; row < turns.size(); ++row) {
        x[turns[row]] = right_hand_side[signed_size(row)];
    }
    for (const Front& front : plan_.fronts) {
        FrontSolve(plan_, front, factor_.data()).forward(x, scratch);
    }
    for (auto front = plan_.fronts.rbegin(); front != plan_.fronts.rend(); ++front) {
        FrontSolve(plan_, *front, factor_.data()).backward(x, scratch);
    }
    Eigen::VectorXd solution(right_hand_side.size());
    for (std::size_t row = 0; row < turns.size(); ++row) {
        solution[signed_size(row)] = x[turns[row]];
    }
    return solution;
}

std::size_t SparseLdlt::nonzeros() const {
    std::size_t count = 0;
    for (const Front& front : plan_.fronts) {
        count += front.pivots * (front.pivots + 1) / 2 + front.pivots * front.border;
    }
    return count;
}

std::size_t SparseLdlt::positive_pivots() const {
    std::size_t count = 0;
    for (const Front& front : plan_.fronts) {
        for (std::size_t pivot = 0; pivot < front.pivots; ++pivot) {
            count += factor_[front.panel_begin + pivot * (front.rows() + 1)] > 0.0 ? 1U : 0U;
        }
    }
    return count;
}

}  // namespace foam
