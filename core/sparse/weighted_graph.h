#pragma once

#include "core/sparse/node_graph.h"

#include <cstdint>
#include <span>
#include <vector>

namespace foam {

/// An undirected graph without loops, whose nodes and edges have weights, as adjacency lists.
struct WeightedGraph {
    struct Edge {
        std::uint32_t to = 0;
        int weight = 1;
    };

    std::vector<int> weights;  // of the nodes, positive
    std::vector<Edge> edges;   // of all nodes, node after node; each edge is at both its ends
    std::vector<std::uint32_t> begins;  // of each node's edges, and the end

    std::uint32_t size() const { return static_cast<std::uint32_t>(weights.size()); }
    std::span<const Edge> of(std::uint32_t node) const {
        return std::span(edges).subspan(begins[node], begins[node + 1] - begins[node]);
    }
};

/// A smaller graph of the same shape.
struct CoarseGraph {
    WeightedGraph graph;
    std::vector<std::uint32_t> coarse_of;  // for each node of the fine graph
};

/// Merges pairs of neighbors: each node with the neighbor that it shares the heaviest edge with, of
/// those not yet merged (Karypis and Kumar 1998, "heavy-edge matching"). The weights of merged
/// nodes and of parallel edges add up. No pair gets heavier than `most_weight`.
CoarseGraph coarsen(const WeightedGraph& fine, int most_weight);

}  // namespace foam
