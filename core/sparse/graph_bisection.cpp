// SPDX-License-Identifier: Apache-2.0

#include "core/sparse/graph_bisection.h"

#include "core/sparse/separator_refinement.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <utility>

namespace foam {

// This is multilevel bisection by recursion (Karypis and Kumar 1998). The graph is coarsened, and
// the coarse graph is bisected. The zones are then transferred to the finer graph, and the
// separator is refined. The coarsest graph is divided by growing the zone Low from a node. Several
// nodes are tried in turn, and the division with the lightest separator after refinement is kept.

namespace {

// A graph with at most this many nodes is not coarsened further.
constexpr std::uint32_t kCoarsestNodes = 100;

// Coarsening ends when the coarser graph would have more than this fraction of the nodes of the
// finer graph.
constexpr double kMaxSizeRatio = 0.9;

// The largest number of breadth-first searches in the coarsest graph. They start at nodes whose
// indices are evenly spaced.
constexpr std::uint32_t kMaxSearches = 4;

int total_weight(const WeightedGraph& graph) {
    return std::accumulate(graph.weights.begin(), graph.weights.end(), 0);
}

// Returns all nodes in the order of a breadth-first search from `start`. If the graph has several
// components, the search continues after each component at the first node that has not been found.
std::vector<std::uint32_t> breadth_first(const WeightedGraph& graph, std::uint32_t start) {
    std::vector<std::uint32_t> order;
    std::vector<bool> is_found(graph.size(), false);
    const auto find = [&](std::uint32_t node) {
        if (!is_found[node]) {
            is_found[node] = true;
            order.push_back(node);
        }
    };
    std::size_t next = 0;
    const auto find_component = [&](std::uint32_t node) {
        find(node);
        for (; next < order.size(); ++next) {
            for (const WeightedGraph::Edge& edge : graph.edges_of(order[next])) {
                find(edge.to);
            }
        }
    };
    find_component(start);
    for (std::uint32_t node = 0; node < graph.size(); ++node) {
        find_component(node);
    }
    return order;
}

// Grows the zone Low from a node. A breadth-first search adds nodes to Low as long as the weight of
// Low is at most half of the total weight. The neighbors of Low are the separator, and all
// remaining nodes are in High.
std::vector<Zone> grow(const WeightedGraph& graph, std::uint32_t start) {
    std::vector<Zone> zones(graph.size(), Zone::High);
    int rest = total_weight(graph) / 2;
    for (const std::uint32_t node : breadth_first(graph, start)) {
        rest -= graph.weights[node];
        if (rest < 0) {
            break;
        }
        zones[node] = Zone::Low;
    }
    for (std::uint32_t node = 0; node < graph.size(); ++node) {
        const auto edges = graph.edges_of(node);
        if (zones[node] == Zone::High && std::any_of(edges.begin(), edges.end(), [&](auto edge) {
                return zones[edge.to] == Zone::Low;
            })) {
            zones[node] = Zone::Outside;
        }
    }
    return zones;
}

// Refines the separator. Returns its cost (SeparatorRefinement::cost).
std::pair<int, int> refine(const WeightedGraph& graph, std::vector<Zone>& zones) {
    SeparatorRefinement refinement(graph, max_zone_weight(total_weight(graph)), zones);
    refinement.run();
    return refinement.cost();
}

std::vector<Zone> bisect_coarsest(const WeightedGraph& graph) {
    std::vector<Zone> best;
    std::pair<int, int> best_cost;
    const std::uint32_t searches = std::min(kMaxSearches, graph.size());
    for (std::uint32_t search = 0; search < searches; ++search) {
        std::vector<Zone> zones = grow(graph, search * graph.size() / searches);
        const std::pair cost = refine(graph, zones);
        if (best.empty() || cost < best_cost) {
            best = std::move(zones);
            best_cost = cost;
        }
    }
    return best;
}

}  // namespace

int max_zone_weight(int weight) {
    return weight / 5 * 3;
}

std::vector<Zone> bisect(const WeightedGraph& graph) {
    if (graph.size() <= kCoarsestNodes) {
        return bisect_coarsest(graph);
    }
    const int max_weight = 3 * total_weight(graph) / (2 * static_cast<int>(kCoarsestNodes));
    const CoarseGraph coarse = coarsen(graph, max_weight);
    if (coarse.graph.size() > kMaxSizeRatio * graph.size()) {
        return bisect_coarsest(graph);
    }
    const std::vector<Zone> coarse_zones = bisect(coarse.graph);
    std::vector<Zone> zones(graph.size());
    for (std::uint32_t node = 0; node < graph.size(); ++node) {
        zones[node] = coarse_zones[coarse.coarse_of[node]];
    }
    refine(graph, zones);
    return zones;
}

}  // namespace foam
