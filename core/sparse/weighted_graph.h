// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/sparse/node_graph.h"

#include <cstdint>
#include <span>
#include <vector>

namespace foam {

/// An undirected graph without loops, with weights of nodes and edges, as adjacency lists.
struct WeightedGraph {
    struct Edge {
        std::uint32_t to = 0;
        int weight = 1;
    };

    std::vector<int> weights;           // weights of the nodes, positive
    std::vector<Edge> edges;            // sorted by node; each edge occurs at both its ends
    std::vector<std::uint32_t> begins;  // start of each node's edges, and the end of the last

    std::uint32_t size() const { return static_cast<std::uint32_t>(weights.size()); }
    std::span<const Edge> of(std::uint32_t node) const {
        return std::span(edges).subspan(begins[node], begins[node + 1] - begins[node]);
    }
};

/// A coarser graph, in which some nodes of the fine graph are merged.
struct CoarseGraph {
    WeightedGraph graph;
    std::vector<std::uint32_t> coarse_of;  // coarse node of each fine node
};

/// Merges pairs of neighbors: each node is merged with the unmerged neighbor to which its edge is
/// heaviest ("heavy-edge matching", Karypis and Kumar 1998). The weights of merged nodes and of
/// parallel edges are added up. No merged pair is heavier than `max_weight`.
CoarseGraph coarsen(const WeightedGraph& fine, int max_weight);

}  // namespace foam
