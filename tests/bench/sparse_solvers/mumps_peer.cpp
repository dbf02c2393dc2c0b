// SPDX-License-Identifier: Apache-2.0

#include "tests/bench/sparse_solvers/peers.h"

#include <dmumps_c.h>
#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <stdexcept>

namespace foam::bench {

namespace {

constexpr int kUseCommWorld = -987654;  // MUMPS's number for MPI_COMM_WORLD

// The names of the orders of elimination, at their numbers in ICNTL(7) and INFOG(7).
constexpr std::array<const char*, 7> kOrderings = {
    "AMD", "given", "AMF", "SCOTCH", "PORD", "METIS", "QAMD"};
constexpr int kMetis = 5;  // MUMPS uses another order if it lacks METIS

enum Job { Begin = -1, End = -2, Analyze = 1, Factor = 2, Solve = 3 };

// An instance of MUMPS for a general symmetric matrix (SYM = 2), whose pivots are chosen for
// stability. Indices in the manual of MUMPS begin at 1.
class Mumps {
  public:
    explicit Mumps(const Eigen::SparseMatrix<double>& lower) : values_(lower) {
        for (int col = 0; col < values_.cols(); ++col) {
            for (Eigen::SparseMatrix<double>::InnerIterator it(values_, col); it; ++it) {
                rows_.push_back(static_cast<int>(it.row()) + 1);
                cols_.push_back(col + 1);
            }
        }
        id_.comm_fortran = kUseCommWorld;
        id_.par = 1;
        id_.sym = 2;
        run(Begin);
        std::fill_n(id_.icntl, 4, 0);  // prints nothing
        id_.icntl[7 - 1] = kMetis;
        id_.n = static_cast<int>(values_.rows());
        id_.nnz = values_.nonZeros();
        id_.irn = rows_.data();
        id_.jcn = cols_.data();
        id_.a = values_.valuePtr();
    }
    Mumps(const Mumps&) = delete;
    Mumps& operator=(const Mumps&) = delete;
    ~Mumps() {
        id_.job = End;
        dmumps_c(&id_);
    }

    void run(Job job) {
        id_.job = job;
        dmumps_c(&id_);
        if (infog(1) < 0) {
            throw std::runtime_error(fmt::format("MUMPS failed: INFOG(1) = {}", infog(1)));
        }
    }

    Eigen::VectorXd solve(Eigen::VectorXd right_side) {
        id_.rhs = right_side.data();
        id_.nrhs = 1;
        id_.lrhs = id_.n;
        run(Solve);
        return right_side;
    }

    int infog(std::size_t number) const { return id_.infog[number - 1]; }
    Permutation positions() const { return Permutation::Map(id_.sym_perm, id_.n).array() - 1; }

  private:
    Eigen::SparseMatrix<double> values_;
    std::vector<int> rows_;
    std::vector<int> cols_;
    DMUMPS_STRUC_C id_{};
};

}  // namespace

Result mumps_result(const System& system) {
    Mumps solver(system.lower);
    Result result;
    result.analysis_seconds = min_seconds([&] { solver.run(Analyze); });
    result.factor_seconds = min_seconds([&] { solver.run(Factor); });
    Eigen::VectorXd x;
    result.solve_seconds = min_seconds([&] { x = solver.solve(system.right_side); });
    result.residual = residual(system.lower, x, system.right_side);
    result.solver =
        fmt::format("MUMPS LDLᵀ, {}", kOrderings.at(static_cast<std::size_t>(solver.infog(7))));
    result.positions = solver.positions();
    const double numbers = solver.infog(29);
    result.numbers = numbers < 0.0 ? -1e6 * numbers : numbers;  // negative: number in millions
    result.bytes = 1e6 * solver.infog(22);
    return result;
}

}  // namespace foam::bench
