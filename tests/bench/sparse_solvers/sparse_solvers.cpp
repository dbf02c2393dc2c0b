// SPDX-License-Identifier: Apache-2.0

// Compares our sparse solver and its order of elimination with other solvers, as Markdown tables.
// Omits the peers that were not installed when this program was built.

#include "tests/bench/largest_argument.h"
#include "tests/bench/sparse_solvers/peers.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <functional>

namespace foam::bench {

namespace {

constexpr const char* kUsage = R"(Usage: sparse_solvers [LARGEST]

Prints Markdown tables that compare our sparse solver with Eigen, CHOLMOD and MUMPS, and our order
of elimination with METIS's: for foams in equilibrium of 1,000, 10,000 and 100,000 bubbles, and for
tangled foams of 20,000 bubbles, whose positions do not tell which of them are neighbors. LARGEST is
the largest number of bubbles, by default 100,000; all together take a quarter of an hour.
)";

constexpr const char* kLegend =
    R"(Least processor time of up to five runs, on one thread. Memory: L and all other memory of the
factorization, for foamtex without indices. L: its number of entries without the zeros that a solver
keeps. Work: the sum over the columns of this L of their squared number of entries. Residual:
|A x - b| / (|A| |x| + |b|). (1) A positive definite matrix of the same pattern: the Hessian has
negative pivots, for which CHOLMOD has no supernodal factorization.
)";

constexpr int kTangledBubbles = 20000;

// Several systems of one kind, which differ in their seeds.
struct Kind {
    std::string name;
    int bubbles = 0;
    std::uint64_t first_seed = 1;
    std::uint64_t seeds = 1;
    bool compares_solvers = true;  // compares all solvers for the first seed
    std::function<System(int bubbles, std::uint64_t seed)> make;
};

std::vector<Kind> all_kinds() {
    const auto overshot = [](double length) {
        return [length](int bubbles, std::uint64_t seed) {
            return overshot_system(bubbles, seed, length);
        };
    };
    return {
        {"in equilibrium", 1000, 1, 20, true, relaxed_system},
        {"in equilibrium", 10000, 1, 5, true, relaxed_system},
        {"in equilibrium", 100000, 1, 3, true, relaxed_system},
        {"after a whole step of Newton's method", kTangledBubbles, 3, 5, false, overshot(1.0)},
        {"after 20 times a step of Newton's method", kTangledBubbles, 3, 5, true, overshot(20.0)},
        {"all at one position", kTangledBubbles, 3, 1, false, collapsed_system}};
}

// Returns the text of a table cell, which is empty for an unknown value.
std::string cell(double value, int decimals) {
    return std::isnan(value) ? "" : fmt::format("{:.{}f}", value, decimals);
}

void print_result(const Result& result, const System& system) {
    const Elimination elimination = count_elimination(system.lower, result.positions);
    fmt::print("| {} | {} | {} | {} | {} | {} | {:.2f} | {:.3f} | {} |\n",
               result.solver,
               cell(1e3 * result.analysis_seconds, 1),
               cell(1e3 * result.factor_seconds, 1),
               cell(1e3 * result.solve_seconds, 2),
               cell(1e-6 * result.bytes, 1),
               cell(1e-6 * result.numbers, 2),
               1e-6 * elimination.numbers,
               1e-9 * elimination.operations,
               std::isnan(result.residual) ? "" : fmt::format("{:.1e}", result.residual));
    static_cast<void>(std::fflush(stdout));
}

void print_solvers(const Kind& kind, const System& system) {
    fmt::print(
        "\n{} bubbles {}, {} rows\n\n"
        "| solver | analysis, ms | factor, ms | solve, ms | memory, MB | L as stored, M | L, M "
        "| work, Gflop | residual |\n|---|---|---|---|---|---|---|---|---|\n",
        kind.bubbles,
        kind.name,
        system.lower.rows());
    for (const auto& run : {foamtex_results, peer_results}) {
        for (const Result& result : run(system)) {
            print_result(result, system);
        }
    }
}

double median(std::vector<double> values) {
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

// Compares the time and the work of our order of elimination with METIS's order, for all systems of
// a kind.
class OrderTally {
  public:
    void add(const System& system) {
        const std::optional<Result> metis = metis_order(system);
        if (!metis) {
            return;
        }
        const Result ours = foamtex_order(system);
        milliseconds_.push_back(1e3 * ours.analysis_seconds);
        metis_milliseconds_.push_back(1e3 * metis->analysis_seconds);
        work_.push_back(count_elimination(system.lower, ours.positions).operations);
        metis_work_.push_back(count_elimination(system.lower, metis->positions).operations);
        ratios_.push_back(work_.back() / metis_work_.back());
    }

    // Returns a row of the table of orders, or an empty text if METIS is not built in.
    std::string row(const Kind& kind) const {
        return ratios_.empty()
                   ? ""
                   : fmt::format(
                         "| {} bubbles {} | {} | {:.1f} | {:.1f} | {:.3f} | {:.3f} | {:.3f} "
                         "| {:.3f} |\n",
                         kind.bubbles,
                         kind.name,
                         kind.seeds,
                         median(milliseconds_),
                         median(metis_milliseconds_),
                         1e-9 * median(work_),
                         1e-9 * median(metis_work_),
                         median(ratios_),
                         std::ranges::max(ratios_));
    }

  private:
    std::vector<double> milliseconds_;
    std::vector<double> metis_milliseconds_;
    std::vector<double> work_;
    std::vector<double> metis_work_;
    std::vector<double> ratios_;
};

// Prints the table of the solvers for a kind, and returns its row of the table of orders.
std::string compare(const Kind& kind) {
    OrderTally orders;
    for (std::uint64_t k = 0; k < kind.seeds; ++k) {
        const System system = kind.make(kind.bubbles, kind.first_seed + k);
        if (k == 0 && kind.compares_solvers) {
            print_solvers(kind, system);
        }
        orders.add(system);
    }
    return orders.row(kind);
}

void print_tables(int largest) {
    fmt::print("{}", kLegend);
    std::string order_rows;
    for (const Kind& kind : all_kinds()) {
        order_rows += kind.bubbles <= largest ? compare(kind) : "";
    }
    if (order_rows.empty()) {  // without METIS
        return;
    }
    fmt::print(
        "\n| order of elimination | seeds | ours, ms | METIS, ms | ours, Gflop | METIS, Gflop "
        "| ours / METIS | worst |\n|---|---|---|---|---|---|---|---|\n{}",
        order_rows);
}

}  // namespace

}  // namespace foam::bench

int main(int argc, char** argv) {
    using namespace foam::bench;
    try {
        print_tables(largest_argument(argc, argv, 100000, kUsage));
    } catch (const std::exception& error) {
        fmt::print(stderr, "sparse_solvers: {}\n", error.what());
        return EXIT_FAILURE;
    }
}
