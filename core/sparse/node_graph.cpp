// SPDX-License-Identifier: Apache-2.0

#include "core/sparse/node_graph.h"

#include <array>

namespace foam {

namespace {

using Matrix = Eigen::SparseMatrix<double>;
using Pair = std::array<std::uint32_t, 2>;

std::vector<std::uint32_t> nodes_of_rows(std::span<const SolverNode> nodes) {
    std::vector<std::uint32_t> owners;
    for (std::uint32_t node = 0; node < nodes.size(); ++node) {
        owners.insert(owners.end(), static_cast<std::size_t>(nodes[node].rows), node);
    }
    return owners;
}

// Returns each pair of coupled nodes once. Two nodes are coupled if the matrix stores an entry in a
// row of one node and a column of the other. The node of lower index is first in each pair, and the
// pairs are sorted by this index.
std::vector<Pair> coupled_pairs(const Matrix& lower, std::span<const SolverNode> nodes) {
    const std::vector<std::uint32_t> owners = nodes_of_rows(nodes);
    // For each node, the last node with which a pair was formed. This is enough to find duplicates,
    // since the columns of a node are consecutive.
    std::vector<std::size_t> last_partner(nodes.size(), nodes.size());
    std::vector<Pair> pairs;
    for (Eigen::Index column = 0; column < lower.cols(); ++column) {
        const std::uint32_t node = owners[static_cast<std::size_t>(column)];
        for (Matrix::InnerIterator entry(lower, column); entry; ++entry) {
            const std::uint32_t other = owners[static_cast<std::size_t>(entry.row())];
            if (other != node && last_partner[other] != node) {
                last_partner[other] = node;
                pairs.push_back({node, other});
            }
        }
    }
    return pairs;
}

}  // namespace

NodeGraph node_graph(const Matrix& lower, std::span<const SolverNode> nodes) {
    const std::vector<Pair> pairs = coupled_pairs(lower, nodes);
    NodeGraph graph;
    graph.begins.assign(nodes.size() + 1, 0);
    for (const auto& [a, b] : pairs) {
        ++graph.begins[a + 1];
        ++graph.begins[b + 1];
    }
    for (std::size_t node = 0; node < nodes.size(); ++node) {
        graph.begins[node + 1] += graph.begins[node];
    }
    graph.neighbors.resize(2 * pairs.size());
    std::vector<std::size_t> next(graph.begins.begin(), graph.begins.end() - 1);
    for (const auto& [a, b] : pairs) {
        graph.neighbors[next[a]++] = b;
        graph.neighbors[next[b]++] = a;
    }
    return graph;
}

}  // namespace foam
