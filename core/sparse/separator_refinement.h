// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/sparse/weighted_graph.h"
#include "core/sparse/zone.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <queue>
#include <span>
#include <utility>
#include <vector>

namespace foam {

/// Makes a separator lighter (of less total weight) by moving nodes between zones. Each node of the
/// graph is in the zone Low, High or Outside; the nodes in Outside are the separator. No node of
/// Low is a neighbor of a node of High.
///
/// A move takes a node from the separator into one zone, and the node's neighbors in the other zone
/// into the separator. In a sweep all moves are into the same zone, so that the separator advances
/// through the other zone. Each step makes the move that leaves the lightest separator, even if
/// this separator is heavier than before. At the end of the sweep, its best separator (cost) is
/// restored. Sweeps into both zones alternate until neither makes the separator lighter or the
/// zones better balanced. This is the method of Fiduccia and Mattheyses (1982), adapted to vertex
/// separators (Karypis and Kumar 1998).
class SeparatorRefinement {
  public:
    /// Keeps references to the graph and the zones. No move makes a zone heavier than `max_weight`.
    /// Precondition: `zones` has one element per node, and no edge connects Low with High.
    SeparatorRefinement(const WeightedGraph& graph, int max_weight, std::span<Zone> zones);

    /// Runs sweeps until neither direction improves the separator, but at most 20 sweeps. Changes
    /// the zones in place.
    void run();

    /// Returns the weight of the separator, and the absolute difference between the weights of Low
    /// and High. Costs are compared lexicographically; the best separator has the lowest cost.
    std::pair<int, int> cost() const;

  private:
    // A candidate move: a node of the separator, and the weight that the separator loses if the
    // node moves.
    struct Move {
        int gain = 0;
        std::uint32_t node = 0;

        bool operator<(const Move& other) const {
            return gain != other.gain ? gain < other.gain : node > other.node;
        }
    };
    struct Change {
        std::uint32_t node = 0;
        Zone before = Zone::Outside;
    };

    bool sweep(Zone into);
    void start_sweep(Zone into);
    bool make_best_move(Zone into);
    void pull_into_separator(std::uint32_t node, Zone from);
    void add_move(std::uint32_t node);
    void change(std::uint32_t node, Zone zone);
    void undo_changes_from(std::size_t first);
    int& weight(Zone zone) { return weights_[static_cast<std::size_t>(zone)]; }
    int gain(std::uint32_t node) const { return graph_.weights[node] - pulled_weights_[node]; }
    int weight_of_neighbors(std::uint32_t node, Zone zone) const;

    const WeightedGraph& graph_;
    int max_weight_;
    std::span<Zone> zones_;
    std::array<int, 3> weights_{};  // weight of each zone
    // Nodes of the separator. May also contain nodes that have left the separator.
    std::vector<std::uint32_t> separator_;
    // For each node of the separator, the weight of the nodes that its move pulls into the
    // separator.
    std::vector<int> pulled_weights_;
    std::priority_queue<Move> moves_;  // may contain outdated moves
    std::vector<Change> changes_;      // changes of the present sweep
};

}  // namespace foam
