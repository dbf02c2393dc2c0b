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
    const Eigen::SparseMatrix<double>& evaluate(const Foam& foam);

    const Eigen::SparseMatrix<double>& matrix() const { return matrix_; }

  private:
    // Of the six numbers that a film's energy depends on: x and y of its tail and head, and the
    // pressures on its left and right.
    using FilmRows = std::array<int, 6>;
    using FilmSlots = std::array<int, 36>;  // place of each entry among the matrix' values, or -1

    FilmRows rows_of(const Network& network, FilmId film) const;
    FilmSlots slots_of(const FilmRows& rows) const;

    const Unknowns& unknowns_;
    Eigen::SparseMatrix<double> matrix_;
    std::vector<FilmSlots> slots_;
};

}  // namespace foam
