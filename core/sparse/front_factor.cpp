// SPDX-License-Identifier: Apache-2.0

#include "core/sparse/front_factor.h"

#include "core/parallel/parallel_for.h"
#include "core/sparse/partial_ldlt.h"

#include <algorithm>
#include <atomic>
#include <cstdint>

namespace foam {

// The multifrontal method (Duff, Reid 1983): fronts are processed in postorder. A front consists of
// its panel and its update matrix (Front). The update matrix is added to the parent front. If there
// are several threads, the two subtrees of a front whose `may_fork` is true are factored at the
// same time. All sums are taken in the same order for any number of threads.

namespace {

template <class Real>
class Factorization {
  public:
    Factorization(const FrontPlan& plan, const FactorMemory<Real>& memory)
        : plan_(plan), memory_(memory) {}

    bool run(std::size_t threads) {
        factor_subtree(plan_.fronts.size() - 1, 0, threads);
        return !failed_;
    }

  private:
    // Factors a subtree with `threads` threads. Thread k of them, counted from 0, uses the scratch
    // memory with the index first_thread + k.
    void factor_subtree(std::size_t root, std::size_t first_thread, std::size_t threads) {
        const Front& front = plan_.fronts[root];
        if (threads == 1 || !front.may_fork) {
            for (std::size_t k = front.first_descendant; k <= root; ++k) {
                factor_front(plan_.fronts[k], first_thread);
            }
            return;
        }
        const std::size_t half = threads / 2;
        parallel_for(2, 2, [&](int which) {
            if (which == 0) {
                factor_subtree(front.left, first_thread, half);
            } else {
                factor_subtree(front.right, first_thread + half, threads - half);
            }
        });
        factor_front(front, first_thread);
    }

    void factor_front(const Front& front, std::size_t thread) {
        if (failed_) {
            return;
        }
        assemble(front);
        Real* scratch = memory_.scratch.data() + thread * plan_.scratch_size;
        const DenseView<Real> panel(memory_.factor.data() + front.panel_begin,
                                    signed_size(front.rows()),
                                    signed_size(front.pivots));
        const DenseView<Real> update_matrix(memory_.workspace.data() + front.update_begin,
                                            signed_size(front.border),
                                            signed_size(front.border));
        if (factor_panel(panel, scratch)) {
            complete_update_matrix(panel, update_matrix, scratch);
        } else {
            failed_ = true;
        }
    }

    // Sets the panel and the update matrix of a front to 0. Then writes those entries of the sparse
    // matrix that belong to the front, and adds the update matrices of the two children.
    void assemble(const Front& front) {
        const auto panel = memory_.factor.subspan(front.panel_begin, front.pivots * front.rows());
        const auto update_matrix =
            memory_.workspace.subspan(front.update_begin, front.border * front.border);
        std::fill(panel.begin(), panel.end(), Real(0));
        std::fill(update_matrix.begin(), update_matrix.end(), Real(0));
        for (std::size_t k = front.entries_begin; k < front.entries_end; ++k) {
            const FrontPlan::Entry& entry = plan_.entries[k];
            panel[entry.target] = static_cast<Real>(memory_.values[entry.source]);
        }
        if (!front.is_leaf()) {
            add_update_matrix(plan_.fronts[front.left], front);
            add_update_matrix(plan_.fronts[front.right], front);
        }
    }

    // Adds the update matrix of a child to the panel and the update matrix of its parent front.
    void add_update_matrix(const Front& child, const Front& front) {
        const std::span<const std::uint32_t> slots = plan_.slots_of_border(child);
        const Real* source = memory_.workspace.data() + child.update_begin;
        for (std::size_t column = 0; column < child.border; ++column) {
            const std::size_t slot = slots[column];
            const bool in_panel = slot < front.pivots;
            Real* target = in_panel
                               ? memory_.factor.data() + front.panel_begin + slot * front.rows()
                               : memory_.workspace.data() + front.update_begin +
                                     (slot - front.pivots) * front.border;
            const std::size_t first_slot = in_panel ? 0 : front.pivots;
            for (std::size_t row = column; row < child.border; ++row) {
                target[slots[row] - first_slot] += source[row];
            }
            source += child.border;
        }
    }

    const FrontPlan& plan_;
    FactorMemory<Real> memory_;
    std::atomic<bool> failed_ = false;
};

}  // namespace

template <class Real>
bool factor_fronts(const FrontPlan& plan, const FactorMemory<Real>& memory, std::size_t threads) {
    return Factorization<Real>(plan, memory).run(threads);
}

template bool factor_fronts(const FrontPlan&, const FactorMemory<float>&, std::size_t);
template bool factor_fronts(const FrontPlan&, const FactorMemory<double>&, std::size_t);

}  // namespace foam
