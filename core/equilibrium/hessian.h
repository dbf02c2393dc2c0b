#pragma once

#include "core/equilibrium/unknowns.h"

#include <Eigen/SparseCore>

#include <array>
#include <vector>

namespace foam {

/// Second derivatives of L by the unknowns (E3), lower triangle, for one network.
/// The pattern and the place of every film's contribution are found once; `evaluate` then only adds
/// up.
class Hessian {
  public:
    Hessian(const Network& network, const Unknowns& unknowns);

    /// The matrix at the foam's present state. The foam must have the network of the constructor.
    /// The same bits for any number of threads.
    const Eigen::SparseMatrix<double>& evaluate(const Foam& foam, int threads = 1);

    const Eigen::SparseMatrix<double>& matrix() const { return matrix_; }

    /// Every column begins with its diagonal entry.
    double& diagonal(int row) { return matrix_.valuePtr()[matrix_.outerIndexPtr()[row]]; }

  private:
    // The free junctions, then the free bubbles, then the half angles of outer films are the nodes
    // of the pattern: two rows, or one. A film couples four, its tail, its head, and the bubbles on
    // its left and on its right; an outer one couples its half angle too.
    static constexpr std::size_t kMostNodes = 5;
    using FilmNodes = std::array<int, kMostNodes>;  // negative where held, or not there
    struct FilmPlace {
        // For each pair of them: where the block of the first one's rows in the second one's
        // first column begins among the matrix' values; negative where not in the lower triangle.
        std::array<int, kMostNodes * kMostNodes> blocks;
        std::array<int, kMostNodes> strides;  // from there to the second column, where there is one
    };
    struct NodePattern;

    FilmNodes nodes_of(const Network& network, FilmId film) const;
    void fill_pattern(const NodePattern& pattern);
    FilmPlace place_of(const NodePattern& pattern, const FilmNodes& nodes) const;
    int rows_before(const NodePattern& pattern, int node, int later) const;
    template <int Rows>
    void add_film(const FilmPlace& place, const Eigen::Matrix<double, Rows, Rows>& film);
    void add_outer_film(const FilmPlace& place, const Foam& foam, FilmId film);
    int rows_of(int node) const { return node < junctions_ ? 2 : 1; }
    int first_row_of(int node) const { return node < junctions_ ? 2 * node : junctions_ + node; }

    const Unknowns& unknowns_;
    int junctions_;
    Eigen::SparseMatrix<double> matrix_;
    std::vector<FilmPlace> places_;  // of the free films
};

}  // namespace foam
