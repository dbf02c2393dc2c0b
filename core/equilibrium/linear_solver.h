#pragma once

#include "core/sparse/sparse_ldlt.h"
#include "core/equilibrium/unknowns.h"
#include "core/foam/foam.h"

#include <Eigen/SparseCore>

#include <vector>

namespace foam {

/// The unknowns of a foam where they stand: junctions at their positions, the pressure of a bubble
/// in the middle of its junctions, the half angle of an outer film in the middle of its chord. In
/// the order of the rows.
std::vector<SolverNode> solver_nodes(const Foam& foam, const Unknowns& unknowns);

/// Of the factor. Single takes half the time and memory, and is enough for steps whose residual is
/// taken in double precision, unless a pivot is nearly zero.
enum class Precision { Single, Double };

/// Solves with the Hessian of E3, lower triangle given: near a stable state it is quasi-definite,
/// so that no pivoting is needed.
class LinearSolver {
  public:
    /// Positions only guide the order of elimination: what follows stays good while the foam moves,
    /// and as long as its network is the same. 0 threads are as many as the machine runs at once.
    void start(const Foam& foam, const Unknowns& unknowns, Precision precision, int threads = 0);

    /// All matrices have the pattern of the first since `start`. False where a pivot vanished:
    /// there is then nothing to solve with.
    bool factor(const Eigen::SparseMatrix<double>& matrix);

    /// To about six digits with a factor of single precision.
    Eigen::VectorXd solve(const Eigen::VectorXd& right_hand_side) const;

  private:
    std::vector<SolverNode> nodes_;
    Domain domain_;
    Precision precision_ = Precision::Double;
    int threads_ = 1;
    bool analyzed_ = false;
    SparseLdlt<float> single_;
    SparseLdlt<double> double_;
};

}  // namespace foam
