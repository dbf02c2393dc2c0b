// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/sparse/node_graph.h"

#include <cstdint>
#include <span>
#include <vector>

namespace foam {

/// An undirected graph with weights of nodes and edges, as adjacency lists. It has no edges from a
/// node to itself.
struct WeightedGraph {
    struct Edge {
        std::uint32_t to = 0;
        int weight = 1;
    };

    std::vector<int> weights;  // weights of the nodes, not negative
    std::vector<Edge> edges;   // sorted by node; each edge occurs at both its ends
    // For each node, the index of its first edge in `edges`; the last element is the size of
    // `edges`.
    std::vector<std::uint32_t> begins;

    /// Returns the number of nodes.
    std::uint32_t size() const { return static_cast<std::uint32_t>(weights.size()); }
    /// Returns the edges of a node.
    std::span<const Edge> edges_of(std::uint32_t node) const {
        return std::span(edges).subspan(begins[node], begins[node + 1] - begins[node]);
    }
};

/// A coarser graph, in which some pairs of nodes of the fine graph are merged.
struct CoarseGraph {
    WeightedGraph graph;
    std::vector<std::uint32_t> coarse_of;  // coarse node of each fine node
};

/// Returns a coarser graph by merging pairs of neighbors. The nodes are visited in their order. A
/// node that is not merged yet is merged with an unmerged neighbor if the weights of both nodes add
/// up to at most `max_weight`. Of several such neighbors, the one with the heaviest edge to the
/// node is taken ("heavy-edge matching", Karypis and Kumar 1998). The weights of merged nodes are
/// added up, and so are the weights of parallel edges.
CoarseGraph coarsen(const WeightedGraph& fine, int max_weight);

}  // namespace foam
