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

/// Makes a separator lighter by moving nodes: each node of the graph is in the zone Low, in the
/// zone High, or Outside, which is the separator, and no node of Low is a neighbor of one of High.
///
/// A move takes a node out of the separator into one zone and its neighbors in the other zone into
/// the separator. In a pass all moves are into the same zone, the best one first, even if the
/// separator gets heavier by it, so that it sweeps over the other zone; then the lightest separator
/// on the way is restored. Passes into both zones alternate until neither gains anything. This is
/// the method of Fiduccia and Mattheyses (1982) for separators of nodes (Karypis and Kumar 1998).
class SeparatorRefinement {
  public:
    /// No zone gets heavier than `most_weight` by a move.
    SeparatorRefinement(const WeightedGraph& graph, int most_weight, std::span<Zone> zones);

    void run();

    /// The weight of the separator, and the difference of the zones' weights.
    std::pair<int, int> cost() const;

  private:
    // A node of the separator that may move, and by how much the separator gets lighter.
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
    int most_weight_;
    std::span<Zone> zones_;
    std::array<int, 3> weights_{};          // of each zone
    std::vector<std::uint32_t> separator_;  // all of its nodes, and some that have left it
    std::vector<int> pulled_;          // weight that the move of a node pulls into the separator
    std::priority_queue<Move> moves_;  // some are out of date
    std::vector<Change> changes_;      // of this sweep
};

}  // namespace foam
