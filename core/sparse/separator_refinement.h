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

/// Makes a separator lighter by moving nodes. Each node of the graph is in the zone Low, in the
/// zone High, or in Outside, which is the separator. No node of Low is a neighbor of a node of
/// High.
///
/// A move takes a node from the separator into one zone, and the node's neighbors in the other zone
/// into the separator. In a sweep all moves are into the same zone, so that the separator moves
/// across the other zone. The best move is made first, even if it makes the separator heavier. At
/// the end the lightest separator of the sweep is restored. Sweeps into both zones alternate until
/// neither makes the separator lighter or the zones better balanced. This is the method of Fiduccia
/// and Mattheyses (1982) for separators of nodes (Karypis and Kumar 1998).
class SeparatorRefinement {
  public:
    /// No move makes a zone heavier than `max_weight`. Precondition: `zones` has one element per
    /// node, and no edge connects Low with High.
    SeparatorRefinement(const WeightedGraph& graph, int max_weight, std::span<Zone> zones);

    /// Runs sweeps until neither direction improves the separator, but at most 20. Changes the
    /// zones in place.
    void run();

    /// Returns the weight of the separator and the difference of the zones' weights.
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
    int gain(std::uint32_t node) const { return graph_.weights[node] - pulled_[node]; }
    int weight_of_neighbors(std::uint32_t node, Zone zone) const;

    const WeightedGraph& graph_;
    int max_weight_;
    std::span<Zone> zones_;
    std::array<int, 3> weights_{};          // weight of each zone
    std::vector<std::uint32_t> separator_;  // its nodes, and some that have left it
    std::vector<int> pulled_;  // for each node, the weight that its move adds to the separator
    std::priority_queue<Move> moves_;  // may contain outdated moves
    std::vector<Change> changes_;      // changes of the present sweep
};

}  // namespace foam
