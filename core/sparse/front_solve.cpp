// SPDX-License-Identifier: Apache-2.0

#include "core/sparse/front_solve.h"

#include "core/parallel/parallel_for.h"

#include <cstdint>
#include <span>

namespace foam {

// Forward substitution processes the fronts in postorder, backward substitution in reverse
// postorder. In each front, a dense triangular system is solved for the pivots, and one
// matrix-vector product connects the pivots with the rows of the border.

namespace {

using Eigen::Index;

// The two substitutions of one front.
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

    // Solves for the pivots in x and subtracts their contribution from the rows of the border. Rows
    // below `limit` are rows of x; the other rows are rows of `beyond`.
    void forward(Vector& x, Vector& beyond, std::size_t limit, Vector& scratch) const {
        auto own = x.segment(first_row_, pivots_);
        auto change = scratch.head(signed_size(border_.size()));
        for (Index column = 0; column < pivots_; ++column) {
            const Index later = pivots_ - column - 1;
            own.tail(later) -= own[column] * top_.col(column).tail(later);
        }
        change.noalias() = below_ * own;
        for (std::size_t k = 0; k < border_.size(); ++k) {
            (border_[k] < limit ? x : beyond)[border_[k]] -= change[signed_size(k)];
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
    Window top_;    // D and the pivots' rows of L
    Window below_;  // the border's rows of L
};

// The two substitutions of all fronts. Of two subtrees that may be processed at the same time, the
// right one subtracts its contributions to later rows from a separate vector, which is then added
// to the result. Neither the order of the sums nor the bits depend on the number of threads.
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

    // Substitutes forward in a subtree. Contributions to the rows from `limit` on are subtracted
    // from `beyond`, which may be x itself.
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
        const std::span<const std::uint32_t> changed =
            plan_.rows_of_border(plan_.fronts[front.right]);
        Vector apart(x_.size());
        for (const std::uint32_t row : changed) {
            apart[row] = Real(0);
        }
        both(threads, [&](bool is_left, std::size_t part) {
            if (is_left) {
                forward(front.left, beyond, limit, part);
            } else {
                forward(front.right, apart, front.first_row, part);
            }
        });
        for (const std::uint32_t row : changed) {
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

    // Returns true if the two subtrees are processed separately. This does not depend on the number
    // of threads, so neither does the order of the sums.
    bool forks(const Front& front) const {
        const std::size_t first_row = plan_.fronts[front.first_descendant].first_row;
        return front.may_fork && front.first_row + front.pivots - first_row >= kMinParallelRows;
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

}  // namespace

template <class Real>
void solve_fronts(const FrontPlan& plan,
                  const Real* factor,
                  Eigen::Vector<Real, Eigen::Dynamic>& x,
                  std::size_t threads) {
    Substitution<Real>(plan, factor, x).run(threads);
}

template void solve_fronts(const FrontPlan&, const float*, Eigen::VectorXf&, std::size_t);
template void solve_fronts(const FrontPlan&, const double*, Eigen::VectorXd&, std::size_t);

}  // namespace foam
