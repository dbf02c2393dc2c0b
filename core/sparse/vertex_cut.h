#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace foam {

/// Where a node stands once the cut is made.
enum class CutSide : std::uint8_t { Source, Cut, Sink };

/// Finds the lightest set of nodes whose removal leaves no path from any source to any sink, by
/// Dinic's maximum flow through the nodes. A source or a sink may itself be cut. Connections are
/// ways from one node to another; into sources and out of sinks none is needed.
///
/// An object keeps its memory between problems; each begins with `reset`.
class VertexCut {
  public:
    /// A new problem over the nodes 0, 1, ... without connections.
    void reset(std::size_t nodes);

    /// To be given once for each node, positive.
    void set_weight(std::size_t node, int weight);
    void make_source(std::size_t node);
    void make_sink(std::size_t node);
    void connect(std::size_t from, std::size_t to);

    /// The side of every node. Of all lightest cuts, the one nearest to the sources.
    const std::vector<CutSide>& solve();

  private:
    // A node is an arc from its entry to its exit, of the node's weight; connections are boundless.
    struct Arc {
        std::uint32_t to = 0;
        std::uint32_t next = 0;  // of the arcs that leave the same place
        int room = 0;
    };

    static std::size_t entry(std::size_t node) { return 2 * node + 2; }
    static std::size_t exit(std::size_t node) { return 2 * node + 3; }

    void add_arc(std::size_t from, std::size_t to, int room);
    bool find_levels();
    int push(std::size_t place, int amount);

    std::size_t nodes_ = 0;
    std::vector<Arc> arcs_;             // an arc and its reverse stand side by side
    std::vector<std::uint32_t> first_;  // arc that leaves each place
    std::vector<std::uint32_t> untried_;
    std::vector<int> levels_;  // steps from the source, -1 out of reach
    std::vector<std::uint32_t> queue_;
    std::vector<CutSide> sides_;
};

}  // namespace foam
