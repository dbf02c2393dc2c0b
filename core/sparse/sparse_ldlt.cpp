#include "core/sparse/sparse_ldlt.h"

#include "core/parallel/parallel_for.h"
#include "core/sparse/front_workspace.h"
#include "core/sparse/partial_ldlt.h"

#include <algorithm>
#include <atomic>
#include <cassert>
#include <optional>
#include <utility>

namespace foam {

namespace {

constexpr std::size_t kFewRows = 3000;  // factored before a thread would have started

using Eigen::Index;

Index signed_size(std::size_t size) {
    return static_cast<Index>(size);
}

// What one call of SparseLdlt::factor works on.
template <class Real>
struct Memory {
    std::span<const double> values;  // of the matrix
    std::span<Real> factor;
    std::span<Real> workspace;
    std::span<Real> scratch;
    std::size_t scratch_per_thread = 0;
};

template <class Real>
class Factorization {
  public:
    Factorization(const FrontPlan& plan, const Memory<Real>& memory)
        : plan_(plan), memory_(memory) {}

    bool run(std::size_t threads) {
        factor_subtree(plan_.fronts.size() - 1, 0, threads);
        return !failed_;
    }

  private:
    // On the given threads, each with scratch memory of its own.
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
        Real* scratch = memory_.scratch.data() + thread * memory_.scratch_per_thread;
        const DenseView<Real> panel(memory_.factor.data() + front.panel_begin,
                                    signed_size(front.rows()),
                                    signed_size(front.pivots));
        const DenseView<Real> remainder(memory_.workspace.data() + front.remainder_begin,
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
        std::fill(panel.begin(), panel.end(), Real(0));
        std::fill(remainder.begin(), remainder.end(), Real(0));
        for (std::size_t k = front.entries_begin; k < front.entries_end; ++k) {
            const FrontPlan::Entry& entry = plan_.entries[k];
            panel[entry.place] = static_cast<Real>(memory_.values[entry.source]);
        }
        if (!front.is_leaf()) {
            take_up(plan_.fronts[front.left], front);
            take_up(plan_.fronts[front.right], front);
        }
    }

    void take_up(const Front& child, const Front& front) {
        const std::span<const std::uint32_t> places = plan_.places_of_border(child);
        const Real* source = memory_.workspace.data() + child.remainder_begin;
        for (std::size_t column = 0; column < child.border; ++column) {
            const std::size_t place = places[column];
            const bool in_panel = place < front.pivots;
            Real* target = in_panel
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
    Memory<Real> memory_;
    std::atomic<bool> failed_ = false;
};

// One front's part in the solution, in the order of elimination.
template <class Real>
class FrontSolve {
  public:
    using Vector = Eigen::Vector<Real, Eigen::Dynamic>;

    FrontSolve(const FrontPlan& plan, const Front& front, const Real* factor)
        : pivots_(signed_size(front.pivots)),
          first_row_(signed_size(front.first_row)),
          border_(plan.rows_of_border(front)),
          top_(factor + front.panel_begin, pivots_, pivots_, stride(front)),
          below_(top_.data() + pivots_, signed_size(front.border), pivots_, stride(front)) {}

    // What the border's rows lose goes to x, from the row `limit` on to `beyond`.
    void forward(Vector& x, Vector& beyond, std::size_t limit, Vector& scratch) const {
        auto own = x.segment(first_row_, pivots_);
        auto share = scratch.head(signed_size(border_.size()));
        for (Index column = 0; column < pivots_; ++column) {
            const Index later = pivots_ - column - 1;
            own.tail(later) -= own[column] * top_.col(column).tail(later);
        }
        share.noalias() = below_ * own;
        for (std::size_t k = 0; k < border_.size(); ++k) {
            (border_[k] < limit ? x : beyond)[border_[k]] -= share[signed_size(k)];
        }
        own.array() /= top_.diagonal().array();
    }

    void backward(Vector& x, Vector& scratch) const {
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
    using Matrix = Eigen::Matrix<Real, Eigen::Dynamic, Eigen::Dynamic>;
    using Window = Eigen::Map<const Matrix, 0, Eigen::OuterStride<>>;

    static Eigen::OuterStride<> stride(const Front& front) {
        return Eigen::OuterStride<>(signed_size(front.rows()));
    }

    Index pivots_;
    Index first_row_;
    std::span<const std::uint32_t> border_;
    Window top_;    // D and the pivots' part of L
    Window below_;  // the border's part of L
};

// Solves in place: forwards through the fronts, and backwards. Subtrees that are gone through at
// the same time subtract their shares of what lies above them from vectors of their own, which are
// then added up in order: the bits do not depend on the number of threads.
template <class Real>
class Substitution {
  public:
    using Vector = Eigen::Vector<Real, Eigen::Dynamic>;

    Substitution(const FrontPlan& plan, const Real* factor, Vector& x)
        : plan_(plan), factor_(factor), x_(x) {}

    void run(std::size_t threads) {
        const std::size_t root = plan_.fronts.size() - 1;
        forward(root, x_, plan_.elimination.size(), threads);
        backward(root, threads);
    }

  private:
    using Solve = FrontSolve<Real>;

    // Shares of rows from `limit` on go to `beyond`, which may be x itself.
    void forward(std::size_t root, Vector& beyond, std::size_t limit, std::size_t threads) {
        const Front& front = plan_.fronts[root];
        Vector scratch(signed_size(plan_.largest_border));
        if (!forks(front)) {
            for (std::size_t k = front.first_descendant; k <= root; ++k) {
                Solve(plan_, plan_.fronts[k], factor_).forward(x_, beyond, limit, scratch);
            }
            return;
        }
        forward_both(front, beyond, limit, threads);
        Solve(plan_, front, factor_).forward(x_, beyond, limit, scratch);
    }

    void forward_both(const Front& front, Vector& beyond, std::size_t limit, std::size_t threads) {
        const std::span<const std::uint32_t> shared =
            plan_.rows_of_border(plan_.fronts[front.right]);
        Vector apart(x_.size());
        for (const std::uint32_t row : shared) {
            apart[row] = Real(0);
        }
        both(threads, [&](bool is_left, std::size_t part) {
            if (is_left) {
                forward(front.left, beyond, limit, part);
            } else {
                forward(front.right, apart, front.first_row, part);
            }
        });
        for (const std::uint32_t row : shared) {
            (row < limit ? x_ : beyond)[row] += apart[row];
        }
    }

    void backward(std::size_t root, std::size_t threads) {
        const Front& front = plan_.fronts[root];
        Vector scratch(signed_size(plan_.largest_border));
        if (!forks(front)) {
            for (std::size_t k = root + 1; k-- > front.first_descendant;) {
                Solve(plan_, plan_.fronts[k], factor_).backward(x_, scratch);
            }
            return;
        }
        Solve(plan_, front, factor_).backward(x_, scratch);
        both(threads, [&](bool is_left, std::size_t part) {
            backward(is_left ? front.left : front.right, part);
        });
    }

    // However many threads there are, the same subtrees are forked.
    bool forks(const Front& front) const {
        const std::size_t first_row = plan_.fronts[front.first_descendant].first_row;
        return front.may_fork && front.first_row + front.pivots - first_row >= kFewRows;
    }

    template <class Body>
    static void both(std::size_t threads, const Body& body) {
        const std::size_t half = threads / 2;
        parallel_for(2, threads > 1 ? 2 : 1, [&](int which) {
            body(which == 0, which == 0 ? half : threads - half);
        });
    }

    const FrontPlan& plan_;
    const Real* factor_;
    Vector& x_;
};

std::size_t threads_for(const FrontPlan& plan, int threads) {
    const bool is_small = plan.elimination.size() < kFewRows;
    return static_cast<std::size_t>(is_small ? 1 : std::clamp(threads, 1, kMostThreads));
}

}  // namespace

template <class Real>
LdltAnalysis SparseLdlt<Real>::analyze(const Eigen::SparseMatrix<double>& lower_pattern,
                                       std::span<const SolverNode> nodes,
                                       const Domain& domain,
                                       const LdltOptions& options,
                                       int threads) {
    std::optional<FrontPlan> plan = plan_fronts(lower_pattern,
                                                nodes,
                                                domain,
                                                options.dissection,
                                                options.max_bytes / sizeof(Real),
                                                threads);
    if (!plan) {
        return LdltAnalysis::TooLarge;
    }
    plan_ = std::move(*plan);
    factor_.resize(plan_.panels_size);
    workspace_.resize(plan_.workspace_size);
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
    const std::size_t used = threads_for(plan_, threads);
    scratch_.resize(std::max(scratch_.size(), used * plan_.scratch_size));
    const Memory<Real> memory{{lower.valuePtr(), plan_.entries.size()},
                              factor_,
                              workspace_,
                              scratch_,
                              plan_.scratch_size};
    return Factorization<Real>(plan_, memory).run(used);
}

template <class Real>
Eigen::VectorXd SparseLdlt<Real>::solve(const Eigen::VectorXd& right_hand_side, int threads) const {
    const auto& turns = plan_.elimination;
    Eigen::Vector<Real, Eigen::Dynamic> x(right_hand_side.size());
    for (std::size_t row = 0; row < turns.size(); ++row) {
        x[turns[row]] = static_cast<Real>(right_hand_side[signed_size(row)]);
    }
    Substitution<Real>(plan_, factor_.data(), x).run(threads_for(plan_, threads));
    Eigen::VectorXd solution(right_hand_side.size());
    for (std::size_t row = 0; row < turns.size(); ++row) {
        solution[signed_size(row)] = static_cast<double>(x[turns[row]]);
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

template <class Real>
std::size_t SparseLdlt<Real>::positive_pivots() const {
    std::size_t count = 0;
    for (const Front& front : plan_.fronts) {
        for (std::size_t pivot = 0; pivot < front.pivots; ++pivot) {
            count += factor_[front.panel_begin + pivot * (front.rows() + 1)] > Real(0) ? 1U : 0U;
        }
    }
    return count;
}

template class SparseLdlt<float>;
template class SparseLdlt<double>;

}  // namespace foam
