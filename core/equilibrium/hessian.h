#pragma once

#include "core/equilibrium/unknowns.h"

#include <Eigen/SparseCore>

#include <array>
#include <vector>

namespace foam {

/// The second derivatives of L by the unknowns (E3) for one network, as a lower triangle. The
/// pattern and the slots of each film's contributions are found once; `evaluate` then only adds.
/// Precondition: the unknowns outlive it.
class Hessian {
  public:
    Hessian(const Network& network, const Unknowns& unknowns);

    /// Returns the matrix at the foam's present state. `threads` as in parallel_for; the bits are
    /// the same for any number. Precondition: the foam has the network of the constructor.
    const Eigen::SparseMatrix<double>& evaluate(const Foam& foam, int threads = 1);

    const Eigen::SparseMatrix<double>& matrix() const { return matrix_; }

    /// Returns the diagonal entry, which is the first of its column.
    double& diagonal(int row) { return matrix_.valuePtr()[matrix_.outerIndexPtr()[row]]; }

  private:
    // The nodes of the pattern are the free junctions, of two rows, then the free bubbles and then
    // the half angles of outer films, of one row each. A film couples four of them: its tail, its
    // head, and the bubbles on its left and right. An outer film couples its half angle, too.
    static constexpr std::size_t kMaxNodes = 5;
    using FilmNodes = std::array<int, kMaxNodes>;  // negative if held, or absent
    // The slots of a film's contribution among the values of the matrix.
    struct FilmSlots {
        // For each pair of nodes, the first slot of the block of the first node's rows in the
        // second node's first column; negative if it is not in the lower triangle.
        std::array<int, kMaxNodes * kMaxNodes> blocks;
        std::array<int, kMaxNodes> strides;  // from a node's first column to its second
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
    std::vector<FilmSlots> slots_;  // of the free films
};

}  // namespace foam
