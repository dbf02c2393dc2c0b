// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "tests/bench/sparse_solvers/elimination.h"
#include "tests/bench/sparse_solvers/system.h"

#include <algorithm>
#include <ctime>
#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace foam::bench {

inline constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();

/// The cost of one solver for one system, on one thread. Unknown values are NaN.
struct Result {
    std::string solver;
    Permutation positions{};
    double analysis_seconds = kUnknown;
    double factor_seconds = kUnknown;
    double solve_seconds = kUnknown;
    double bytes = kUnknown;     // of the factor and all other memory of the factorization
    double numbers = kUnknown;   // numbers stored for L, including explicit zeros
    double residual = kUnknown;  // relative residual (system.h)
};

/// Returns the least processor time of up to five runs. No further run starts when the runs have
/// taken a second in total.
template <class Work>
double min_seconds(const Work& work) {
    double best = std::numeric_limits<double>::infinity();
    double total = 0.0;
    for (int run = 0; run < 5 && total < 1.0; ++run) {
        const std::clock_t start = std::clock();
        work();
        const double time = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
        best = std::min(best, time);
        total += time;
    }
    return best;
}

/// Returns the results of our own solver, in double and in single precision.
std::vector<Result> foamtex_results(const System& system);

/// Returns the results of all peers that were built in.
std::vector<Result> peer_results(const System& system);

/// Returns our order of elimination, and the time to find it.
Result foamtex_order(const System& system);

/// Returns the order of METIS's nested dissection of the graph of nodes, and the time to find it.
/// The weight of a node is its number of rows. Returns nothing if METIS is not built in.
std::optional<Result> metis_order(const System& system);

Result eigen_result(const System& system);
std::vector<Result> cholmod_results(const System& system);
Result mumps_result(const System& system);

}  // namespace foam::bench
