// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/equilibrium/unknowns.h"

#include <Eigen/SparseCore>

#include <array>
#include <vector>

namespace foam {

/// The Hessian of L with respect to the unknowns (E3) for one network, as a lower triangle. The
/// pattern and the slots of each film's contributions are found once, so that `evaluate` only adds.
/// Precondition: the unknowns outlive this object.
class Hessian {
  public:
    Hessian(const Network& network, const Unknowns& unknowns);

    /// Returns the matrix at the present state of the foam. `threads` has the same meaning as in
    /// parallel_for; the result has the same bits for any number of threads. Precondition: the foam
    /// has the network that was given to the constructor.
    const Eigen::SparseMatrix<double>& evaluate(const Foam& foam, int threads = 1);

    const Eigen::SparseMatrix<double>& matrix() const { return matrix_; }

    /// Returns a reference to the diagonal entry of a row, which is the first entry of its column.
    double& diagonal(int row) { return matrix_.valuePtr()[matrix_.outerIndexPtr()[row]]; }

  private:
    // The nodes of the pattern are the free junctions with two rows each, then the free bubbles and
    // the half angles of outer films with one row each. A film couples four nodes: its tail, its
    // head, and the bubbles on its left and right. An outer film also couples its half angle.
    static constexpr std::size_t kMaxNodes = 5;
    using FilmNodes = std::array<int, kMaxNodes>;  // negative if the node is held fixed or absent
    // The slots of a film's contributions in the array of the matrix values.
    struct FilmSlots {
        // For each pair of nodes (a, b) of the film, at index kMaxNodes b + a: the first slot of
        // the block with the rows of a and the columns of b. Negative if the block is not in the
        // lower triangle.
        std::array<int, kMaxNodes * kMaxNodes> blocks;
        std::array<int, kMaxNodes> strides;  // from a block's first column to its second
    };
    struct NodePattern;

    FilmNodes nodes_of(const Network& network, FilmId film) const;
    void fill_pattern(const NodePattern& pattern);
    FilmSlots slots_of(const NodePattern& pattern, const FilmNodes& nodes) const;
    int rows_before(const NodePattern& pattern, int node, int later) const;
    template <int Rows>
    void add_film(const FilmSlots& slots, const Eigen::Matrix<double, Rows, Rows>& film);
    void add_outer_film(const FilmSlots& slots, const Foam& foam, FilmId film);
    int rows_of(int node) const { return node < junctions_ ? 2 : 1; }
    int first_row_of(int node) const { return node < junctions_ ? 2 * node : junctions_ + node; }

    const Unknowns& unknowns_;
    int junctions_;
    Eigen::SparseMatrix<double> matrix_;
    std::vector<FilmSlots> slots_;  // one element per free film
};

}  // namespace foam
