// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/geometry/domain.h"
#include "core/sparse/dissection_options.h"
#include "core/sparse/halving.h"
#include "core/sparse/node_graph.h"
#include "core/sparse/weighted_graph.h"
#include "core/sparse/zone.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace foam {

/// The boxes around the two zones of a divided part. Both have no value if only the edges of the
/// graph, and not the positions of its nodes, determined the division.
struct ZoneBoxes {
    std::optional<PartBox> low;
    std::optional<PartBox> high;
};

/// The working memory of PartDivider, with one element per node of the graph. Parts of the graph
/// that are separated from each other may be divided at the same time. The reason is that the
/// division of one part reads no element that the division of another part writes.
struct DivisionMemory {
    std::vector<Zone> zones;             // all Outside between divisions
    std::vector<std::uint32_t> numbers;  // number in the graph that is divided or refined, or
                                         // kNoNumber

    explicit DivisionMemory(std::size_t nodes)
        : zones(nodes, Zone::Outside), numbers(nodes, kNoNumber) {}
};

/// Divides parts of a graph by separators of few rows (light separators). First divides a part by
/// position: into two halves, with a separator near their border (halving.h). If this separator has
/// too many rows (DissectionOptions), divides the part again by the edges of the graph, without
/// positions. A separator has too many rows, for example, if the positions of neighbors in the
/// graph are far apart.
class PartDivider {
  public:
    /// Keeps references to all arguments except the domain. `nodes` are the nodes of the graph.
    PartDivider(const NodeGraph& graph,
                std::span<const SolverNode> nodes,
                const Domain& domain,
                const DissectionOptions& options,
                DivisionMemory& memory);

    /// Returns a box around all nodes; on a torus this is the fundamental cell.
    PartBox box_of_all() const;

    /// Divides a part whose nodes represent `rows` rows of the matrix. Assigns the nodes of the
    /// separator to the zone Outside, and all other nodes of the part to Low or High. If `box` has
    /// no value, positions are not used. Returns the boxes of both zones. Precondition: all nodes
    /// of other parts that are coupled to nodes of the part are in Outside.
    ZoneBoxes divide(std::span<const std::uint32_t> part,
                     int rows,
                     const std::optional<PartBox>& box);

  private:
    using Nodes = std::span<const std::uint32_t>;

    std::optional<ZoneBoxes> divide_by_position(Nodes part, int rows, const PartBox& box);
    void refine(Nodes part, int rows);
    void move_rest(Nodes part, Zone low, Zone high);
    std::vector<std::uint32_t> nodes_near_separator(Nodes part);
    void add_unnumbered_neighbors(std::uint32_t node, std::vector<std::uint32_t>& nodes);
    void divide_by_graph(Nodes part);
    WeightedGraph graph_of(Nodes part);
    WeightedGraph graph_of_near(Nodes near, Nodes part) const;
    std::array<bool, 2> append_node(std::uint32_t node, WeightedGraph& graph) const;
    void number(Nodes nodes);
    void forget_numbers(Nodes nodes);
    void assign(Nodes nodes, std::span<const Zone> zones);
    int rows_of(Nodes nodes, Zone zone) const;

    const NodeGraph& graph_;
    std::span<const SolverNode> nodes_;
    Domain domain_;
    Vec2 periods_;
    const DissectionOptions& options_;
    DivisionMemory& memory_;
};

}  // namespace foam
