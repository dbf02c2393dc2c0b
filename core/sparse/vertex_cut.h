// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace foam {

/// The side of the cut on which a node is, or the cut itself.
enum class CutSide : std::uint8_t { Source, Cut, Sink };

/// Finds the lightest set of nodes whose removal leaves no path from any source to any sink
/// (minimum vertex cut), by Dinic's maximum flow with node capacities. The cut may contain sources
/// and sinks. Connections are directed. Connections into sources and out of sinks may be omitted.
/// Buffers are reused between problems.
class VertexCut {
  public:
    /// Starts a new problem with the given number of nodes and no connections.
    void reset(std::size_t nodes);

    /// Sets the weight of a node. Precondition: called once for each node, with a positive weight.
    void set_weight(std::size_t node, int weight);
    /// Makes a node a source.
    void make_source(std::size_t node);
    /// Makes a node a sink.
    void make_sink(std::size_t node);
    /// Adds a connection from one node to another.
    void connect(std::size_t from, std::size_t to);

    /// Returns the side of every node. Of several lightest cuts, returns the cut nearest to the
    /// sources.
    const std::vector<CutSide>& solve();

  private:
    // An arc of the flow network. A node is an arc from its entry vertex to its exit vertex, with
    // the weight as its capacity; a connection is an arc of unlimited capacity.
    struct Arc {
        std::uint32_t to = 0;
        std::uint32_t next = 0;  // next arc that leaves the same vertex
        int capacity = 0;
    };

    static std::size_t entry(std::size_t node) { return 2 * node + 2; }
    static std::size_t exit(std::size_t node) { return 2 * node + 3; }

    void add_arc(std::size_t from, std::size_t to, int capacity);
    bool find_levels();
    int push(std::size_t vertex, int amount);

    std::size_t nodes_ = 0;
    std::vector<Arc> arcs_;             // an arc and its reverse are adjacent
    std::vector<std::uint32_t> first_;  // first arc that leaves each vertex
    std::vector<std::uint32_t> untried_;
    std::vector<int> levels_;  // steps from the source, -1 if unreachable
    std::vector<std::uint32_t> queue_;
    std::vector<CutSide> sides_;
};

}  // namespace foam
