// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/equilibrium/unknowns.h"

#include <Eigen/SparseCore>

#include <array>
#include <vector>

namespace foam {

/// The Hessian of L with respect to the unknowns (E3) for one network, as a lower triangle. The
/// constructor determines the sparsity pattern, and the positions in the array of matrix values to
/// which each film contributes, so that `evaluate` only adds numbers. Precondition: the unknowns
/// outlive this object.
class Hessian {
  public:
    Hessian(const Network& network, const Unknowns& unknowns);

    /// Returns the matrix at the present state of the foam. `threads` has the same meaning as in
    /// parallel_for; the result has the same bits for any number of threads. Precondition: the foam
    /// has the network that was given to the constructor.
    const Eigen::SparseMatrix<double>& evaluate(const Foam& foam, int threads = 1);

    /// Returns the matrix of the last call of `evaluate`, with the changes that callers have made
    /// to its diagonal since then (`diagonal`).
    const Eigen::SparseMatrix<double>& matrix() const { return matrix_; }

    /// Returns a reference to the diagonal entry of a row. It is the first value of the column with
    /// the same index, because only the lower triangle is stored.
    double& diagonal(int row) { return matrix_.valuePtr()[matrix_.outerIndexPtr()[row]]; }

  private:
    // The nodes of the pattern are the free junctions with two rows each, then the free bubbles
    // with one row each, then the half angles of free outer films with one row each (Unknowns). A
    // film couples four nodes: its tail, its head, and the bubbles on its left and right. An outer
    // film also couples a fifth node, its half angle.
    static constexpr std::size_t kMaxNodes = 5;
    using FilmNodes = std::array<int, kMaxNodes>;  // negative for an element that is no node
    // The positions of a film's contributions in the array of matrix values.
    struct FilmSlots {
        // Element b * kMaxNodes + a belongs to the elements a and b of FilmNodes. It is the
        // position of the first value of the block with the rows of a and the columns of b. It is
        // negative if one of these elements is negative, or if the block is not in the lower
        // triangle.
        std::array<int, kMaxNodes * kMaxNodes> blocks;
        // Element b belongs to the node b of the film and is used only if the node has two rows. It
        // is the distance, in the array of matrix values, from a value in the node's first column
        // to the value of the same row in its second column.
        std::array<int, kMaxNodes> strides;
    };
    struct NodePattern;

    FilmNodes nodes_of(const Network& network, FilmId film) const;
    void fill_pattern(const NodePattern& pattern);
    FilmSlots slots_of(const NodePattern& pattern, const FilmNodes& nodes) const;
    int rows_before(const NodePattern& pattern, int node, int later_node) const;
    template <int Rows>
    void add_film(const FilmSlots& slots, const Eigen::Matrix<double, Rows, Rows>& film);
    void add_outer_film(const FilmSlots& slots, const Foam& foam, FilmId film);
    int rows_of(int node) const { return node < junctions_ ? 2 : 1; }
    int first_row_of(int node) const { return node < junctions_ ? 2 * node : junctions_ + node; }

    const Unknowns& unknowns_;
    int junctions_;
    Eigen::SparseMatrix<double> matrix_;
    std::vector<FilmSlots> slots_;  // one element per element of Unknowns::films
};

}  // namespace foam
