// SPDX-License-Identifier: Apache-2.0

#include "core/sparse/front_solve.h"

#include "core/parallel/parallel_for.h"

#include <cstdint>
#include <span>

namespace foam {

// Forward substitution processes the fronts in postorder, backward substitution in reverse
// postorder. In each front, a dense triangular system is solved for the pivots. One matrix-vector
// product computes the terms between the pivots and the rows of the border.

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

    // Forward substitution: solves for the pivots' elements of x, subtracts their contributions
    // from the rows of the border, and divides the pivots' elements of x by D. Contributions to
    // rows with an index less than `first_later_row` are subtracted from x, contributions to other
    // rows from `later_rows`.
    void forward(Vector& x,
                 Vector& later_rows,
                 std::size_t first_later_row,
                 Vector& scratch) const {
        auto own = x.segment(first_row_, pivots_);
        auto change = scratch.head(signed_size(border_.size()));
        for (Index column = 0; column < pivots_; ++column) {
            const Index later_pivots = pivots_ - column - 1;
            own.tail(later_pivots) -= own[column] * top_.col(column).tail(later_pivots);
        }
        change.noalias() = below_ * own;
        for (std::size_t k = 0; k < border_.size(); ++k) {
            (border_[k] < first_later_row ? x : later_rows)[border_[k]] -= change[signed_size(k)];
        }
        own.array() /= top_.diagonal().array();
    }

    // Backward substitution: solves for the pivots' elements of x. The elements of the rows of the
    // border are already solved.
    void backward(Vector& x, Vector& scratch) const {
        auto own = x.segment(first_row_, pivots_);
        auto known = scratch.head(signed_size(border_.size()));
        for (std::size_t k = 0; k < border_.size(); ++k) {
            known[signed_size(k)] = x[border_[k]];
        }
        own.noalias() -= below_.transpose() * known;
        for (Index column = pivots_ - 1; column >= 0; --column) {
            const Index later_pivots = pivots_ - column - 1;
            own[column] -= top_.col(column).tail(later_pivots).dot(own.tail(later_pivots));
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

// The two substitutions of all fronts. The function `forks` tells whether the two subtrees of a
// front may be processed at the same time. If they may, the right subtree subtracts its
// contributions to the front's pivots and border from a separate vector. The separate vector is
// then added to the vectors that the left subtree changes. The separate vector is used with any
// number of threads, even with one. Therefore neither the order of the sums nor the bits of the
// result depend on the number of threads.
template <class Real>
class Substitution {
  public:
    using Vector = Eigen::Vector<Real, Eigen::Dynamic>;

    Substitution(const FrontPlan& plan, const Real* factor, Vector& x)
        : plan_(plan), factor_(factor), x_(x) {}

    void run(std::size_t threads) {
        const std::size_t root = plan_.fronts.size() - 1;
        forward(root, x_, plan_.position_of_row.size(), threads);
        backward(root, threads);
    }

  private:
    using Solve = FrontSolve<Real>;

    // Forward substitution in a subtree. Contributions to rows with an index of at least
    // `first_later_row` are subtracted from `later_rows`, which may be x itself.
    void forward(std::size_t root,
                 Vector& later_rows,
                 std::size_t first_later_row,
                 std::size_t threads) {
        const Front& front = plan_.fronts[root];
        Vector scratch(signed_size(plan_.largest_border));
        if (!forks(front)) {
            for (std::size_t k = front.first_descendant; k <= root; ++k) {
                Solve(plan_, plan_.fronts[k], factor_)
                    .forward(x_, later_rows, first_later_row, scratch);
            }
            return;
        }
        forward_subtrees(front, later_rows, first_later_row, threads);
        Solve(plan_, front, factor_).forward(x_, later_rows, first_later_row, scratch);
    }

    // Forward substitution in both subtrees of a front, each with a part of the threads.
    void forward_subtrees(const Front& front,
                          Vector& later_rows,
                          std::size_t first_later_row,
                          std::size_t threads) {
        const std::span<const std::uint32_t> changed =
            plan_.rows_of_border(plan_.fronts[front.right]);
        Vector right_contributions(x_.size());
        for (const std::uint32_t row : changed) {
            right_contributions[row] = Real(0);
        }
        for_both_subtrees(threads, [&](bool is_left, std::size_t part) {
            if (is_left) {
                forward(front.left, later_rows, first_later_row, part);
            } else {
                forward(front.right, right_contributions, front.first_row, part);
            }
        });
        for (const std::uint32_t row : changed) {
            (row < first_later_row ? x_ : later_rows)[row] += right_contributions[row];
        }
    }

    // Backward substitution in a subtree.
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
        for_both_subtrees(threads, [&](bool is_left, std::size_t part) {
            backward(is_left ? front.left : front.right, part);
        });
    }

    // Returns true if the two subtrees of the front are processed separately. The result does not
    // depend on the number of threads, so the order of the sums does not depend on it either.
    bool forks(const Front& front) const {
        const std::size_t first_row = plan_.fronts[front.first_descendant].first_row;
        return front.may_fork && front.first_row + front.pivots - first_row >= kMinParallelRows;
    }

    // Calls body(is_left, number of threads) for both subtrees of a front, at the same time if
    // there are several threads. The number of threads may be 0, which means the same as 1.
    template <class Body>
    static void for_both_subtrees(std::size_t threads, const Body& body) {
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
