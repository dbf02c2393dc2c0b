// SPDX-License-Identifier: Apache-2.0

#include "core/sparse/dissection.h"
#include "core/sparse/sparse_ldlt.h"
#include "tests/bench/sparse_solvers/peers.h"

#include <cstddef>

namespace foam::bench {

namespace {

// Limits the memory if the order of elimination is useless.
constexpr std::size_t kMaxBytes = std::size_t{1} << 30U;

template <class Real>
Result run(const System& system, const std::string& name) {
    Result result = foamtex_order(system);
    result.solver = name;
    SparseLdlt<Real> solver;
    LdltAnalysis analysis = LdltAnalysis::TooLarge;
    result.analysis_seconds = min_seconds([&] {
        const LdltOptions options{.max_bytes = kMaxBytes};
        analysis = solver.analyze(system.lower, system.nodes, system.domain, options);
    });
    if (analysis == LdltAnalysis::TooLarge) {
        result.solver += ": more than 1 GiB planned";
        return result;
    }
    result.bytes = static_cast<double>(solver.memory_bytes(1));
    result.numbers = static_cast<double>(solver.nonzeros());
    bool has_factor = false;
    result.factor_seconds = min_seconds([&] { has_factor = solver.factor(system.lower, 1); });
    if (!has_factor) {
        result.solver += ": no factor, a pivot vanished";
        return result;
    }
    Eigen::VectorXd x;
    result.solve_seconds = min_seconds([&] { x = solver.solve(system.right_side); });
    result.residual = residual(system.lower, x, system.right_side);
    return result;
}

}  // namespace

std::vector<Result> foamtex_results(const System& system) {
    return {run<double>(system, "foamtex, double precision"),
            run<float>(system, "foamtex, single precision")};
}

Result foamtex_order(const System& system) {
    Result result{.solver = "foamtex"};
    Dissection dissection;
    const auto count = static_cast<Eigen::Index>(system.nodes.size());
    const NodeGraph graph = node_graph(system.lower, system.nodes);
    result.analysis_seconds =
        min_seconds([&] { dissection = dissect(graph, system.nodes, system.domain, {}); });
    const std::vector<int> order(dissection.order.begin(), dissection.order.end());
    result.positions =
        positions_of_rows(system.nodes, inverse(Permutation::Map(order.data(), count)));
    return result;
}

}  // namespace foam::bench
