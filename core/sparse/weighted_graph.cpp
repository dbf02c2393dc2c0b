// SPDX-License-Identifier: Apache-2.0

#include "core/sparse/weighted_graph.h"

#include <limits>

namespace foam {

namespace {

constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();

// Returns, for each node, the node with which it is merged, or the node itself if it is not merged.
std::vector<std::uint32_t> match(const WeightedGraph& graph, int max_weight) {
    std::vector<std::uint32_t> partners(graph.size(), kNone);
    for (std::uint32_t node = 0; node < graph.size(); ++node) {
        if (partners[node] != kNone) {
            continue;
        }
        std::uint32_t best = node;
        int best_weight = 0;
        for (const auto& [to, weight] : graph.edges_of(node)) {
            if (partners[to] == kNone && weight > best_weight &&
                graph.weights[node] + graph.weights[to] <= max_weight) {
                best = to;
                best_weight = weight;
            }
        }
        partners[node] = best;
        partners[best] = node;
    }
    return partners;
}

// Appends the edges of one coarse node. `members` are the fine nodes of this coarse node. For a
// neighbor k, which is a coarse node, too, edge_indices[k] is the index of the edge that this call
// has appended. Values from before this call are not reset. They are recognized because they are
// kNone or below `begin`, the index of the first edge that this call appends.
void append_edges(const WeightedGraph& fine,
                  std::span<const std::uint32_t> members,
                  CoarseGraph& coarse,
                  std::vector<std::uint32_t>& edge_indices) {
    WeightedGraph& graph = coarse.graph;
    const std::uint32_t begin = graph.begins.back();
    const std::uint32_t own = coarse.coarse_of[members.front()];
    for (const std::uint32_t member : members) {
        for (const auto& [to, weight] : fine.edges_of(member)) {
            const std::uint32_t other = coarse.coarse_of[to];
            if (other == own) {
                continue;
            }
            std::uint32_t& index = edge_indices[other];
            if (index < begin || index == kNone) {
                index = static_cast<std::uint32_t>(graph.edges.size());
                graph.edges.push_back({other, 0});
            }
            graph.edges[index].weight += weight;
        }
    }
    graph.begins.push_back(static_cast<std::uint32_t>(graph.edges.size()));
}

}  // namespace

CoarseGraph coarsen(const WeightedGraph& fine, int max_weight) {
    const std::vector<std::uint32_t> partners = match(fine, max_weight);
    CoarseGraph coarse;
    coarse.coarse_of.resize(fine.size());
    for (std::uint32_t node = 0; node < fine.size(); ++node) {
        const std::uint32_t partner = partners[node];
        if (partner < node) {
            coarse.coarse_of[node] = coarse.coarse_of[partner];
            continue;
        }
        coarse.coarse_of[node] = coarse.graph.size();
        coarse.graph.weights.push_back(fine.weights[node] +
                                       (partner > node ? fine.weights[partner] : 0));
    }
    std::vector<std::uint32_t> edge_indices(coarse.graph.size(), kNone);
    coarse.graph.begins.push_back(0);
    coarse.graph.edges.reserve(fine.edges.size() / 2);
    for (std::uint32_t node = 0; node < fine.size(); ++node) {
        const std::uint32_t partner = partners[node];
        if (partner >= node) {
            const std::uint32_t members[] = {node, partner};
            append_edges(
                fine, std::span(members).first(partner > node ? 2 : 1), coarse, edge_indices);
        }
    }
    return coarse;
}

}  // namespace foam
