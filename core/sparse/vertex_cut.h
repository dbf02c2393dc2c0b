// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace foam {

/// The side of the cut on which a node is; Cut if the node is in the cut.
enum class CutSide : std::uint8_t { Source, Cut, Sink };

/// Finds the set of nodes of least total weight whose removal leaves no path from any source to any
/// sink (minimum vertex cut). Uses Dinic's maximum flow algorithm; the weight of a node is its
/// capacity. The cut may contain sources and sinks. Connections are directed. Connections into
/// sources and out of sinks may be omitted, since they do not change the cut. Buffers are reused
/// between problems.
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

    /// Returns the side of every node. If several cuts have the least weight, finds the cut nearest
    /// to the sources.
    const std::vector<CutSide>& solve();

  private:
    // An arc (directed edge) of the flow network. A node is an arc from its entry vertex to its
    // exit vertex, with the weight as its capacity; a connection is an arc of unlimited capacity.
    // Vertex 0 is the source of the flow, which has an arc to each node that is a source. Vertex 1
    // is the sink, to which each node that is a sink has an arc.
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
    // For each vertex, the first of its arcs that may still carry flow. Reset after each call of
    // find_levels.
    std::vector<std::uint32_t> untried_;
    std::vector<int> levels_;  // for each vertex, steps from vertex 0; -1 if unreachable
    std::vector<std::uint32_t> queue_;
    std::vector<CutSide> sides_;
};

}  // namespace foam
