// SPDX-License-Identifier: Apache-2.0

#include "tests/bench/sparse_solvers/peers.h"

#include <metis.h>

#include <stdexcept>

namespace foam::bench {

std::optional<Result> metis_order(const System& system) {
    const NodeGraph graph = node_graph(system.lower, system.nodes);
    std::vector<idx_t> begins(graph.begins.begin(), graph.begins.end());
    std::vector<idx_t> neighbors(graph.neighbors.begin(), graph.neighbors.end());
    std::vector<idx_t> weights;
    for (const SolverNode& node : system.nodes) {
        weights.push_back(node.rows);
    }
    auto count = static_cast<idx_t>(system.nodes.size());
    Permutation order(count);
    Permutation positions(count);
    Result result{.solver = "METIS"};
    result.analysis_seconds = min_seconds([&] {
        if (METIS_NodeND(&count,
                         begins.data(),
                         neighbors.data(),
                         weights.data(),
                         nullptr,
                         order.data(),
                         positions.data()) != METIS_OK) {
            throw std::runtime_error("METIS failed");
        }
    });
    result.positions = positions_of_rows(system.nodes, positions);
    return result;
}

}  // namespace foam::bench
