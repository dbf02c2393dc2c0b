// SPDX-License-Identifier: Apache-2.0

#include "core/sparse/part_divider.h"

#include "core/geometry/narrow.h"
#include "core/sparse/graph_bisection.h"
#include "core/sparse/separator_refinement.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>

namespace foam {

// Dividing a part puts each of its nodes into a zone: Low or High, the two sides, or Outside, the
// separator. (Nodes of other parts are in Outside, too.)
//
// A part is halved at the median coordinate along the longer axis of its box. The nodes of one half
// that have neighbors in the other half are a separator. In a part of many rows, the separator is
// then refined: moved through the nodes near it (SeparatorRefinement). If the separator has too
// many rows before or after refinement (DissectionOptions), the part is divided by multilevel
// bisection instead.
//
// A part that extends around the torus is halved by two lines, one at each end of Low. They are at
// the position at which the separator before refinement is lightest.

namespace {

// Refinement may move a separator through this many layers of nodes on each side of it.
constexpr int kRefinedLayers = 6;

}  // namespace

PartDivider::PartDivider(const NodeGraph& graph,
                         std::span<const SolverNode> nodes,
                         const Domain& domain,
                         const DissectionOptions& options,
                         DivisionMemory& memory)
    : graph_(graph),
      nodes_(nodes),
      domain_(domain),
      periods_(periods_of(domain)),
      options_(options),
      memory_(memory) {}

PartBox PartDivider::box_of_all() const {
    if (!domain_.is_plane()) {
        return {Vec2::Zero(), periods_};
    }
    PartBox box{nodes_.front().position, nodes_.front().position};
    for (const SolverNode& node : nodes_) {
        box.low = box.low.cwiseMin(node.position);
        box.high = box.high.cwiseMax(node.position);
    }
    return box;
}

ZoneBoxes PartDivider::divide(Nodes part, int rows, const std::optional<PartBox>& box) {
    if (box) {
        if (const std::optional<ZoneBoxes> boxes = divide_by_position(part, rows, *box)) {
            return *boxes;
        }
    }
    divide_by_graph(part);
    return {};
}

// Halves the part along the longer axis of its box, and refines the separator if the part has many
// rows. Returns no value if the separator has too many rows.
std::optional<ZoneBoxes> PartDivider::divide_by_position(Nodes part, int rows, const PartBox& box) {
    const Eigen::Index axis = box.high.x() - box.low.x() < box.high.y() - box.low.y() ? 1 : 0;
    const double length = box.high[axis] - box.low[axis];
    const bool extends_around = !domain_.is_plane() && length >= periods_[axis];
    const LowRange low =
        extends_around
            ? halve_at_lightest_position(part, nodes_, graph_, periods_[axis], axis, memory_.zones)
            : LowRange{box.low[axis],
                       halve_at_median(part, nodes_, periods_, box, axis, memory_.zones)};
    separate_halves(part, nodes_, graph_, memory_.zones);
    ZoneBoxes boxes{box, box};
    boxes.low->low[axis] = low.begin;
    boxes.low->high[axis] = boxes.high->low[axis] = low.end;
    boxes.high->high[axis] = low.begin + length;
    const double root = std::sqrt(rows);
    if (rows_of(part, Zone::Outside) > options_.heaviest_separator * root) {
        return std::nullopt;
    }
    if (rows >= options_.min_refined_rows) {
        refine(part, rows);
        if (rows_of(part, Zone::Outside) > options_.heaviest_refined * root) {
            return std::nullopt;
        }
    }
    return boxes;
}

// Makes the separator lighter by moving nodes near it between the zones (SeparatorRefinement).
void PartDivider::refine(Nodes part, int rows) {
    std::vector<std::uint32_t> near = nodes_near_separator(part);
    const WeightedGraph graph = graph_of_near(near, part);
    std::vector<Zone> zones;
    zones.reserve(graph.size());
    for (const std::uint32_t node : near) {
        zones.push_back(memory_.zones[node]);
    }
    zones.push_back(Zone::Low);
    zones.push_back(Zone::High);
    SeparatorRefinement(graph, max_zone_weight(rows), zones).run();
    move_rest(part, zones[near.size()], zones[near.size() + 1]);
    forget_numbers(near);
    assign(near, zones);
}

// Sets the zones of those nodes of a part that have no number. The graph that is refined
// (graph_of_near) does not contain these nodes one by one. One of its nodes represents all of them
// in Low, and another node all of them in High. `low` and `high` are the zones of these two nodes
// after refinement.
void PartDivider::move_rest(Nodes part, Zone low, Zone high) {
    for (const std::uint32_t node : part) {
        if (memory_.numbers[node] == kNoNumber) {
            memory_.zones[node] = memory_.zones[node] == Zone::Low ? low : high;
        }
    }
}

// Returns the nodes of the separator, followed by the nodes of kRefinedLayers layers around it.
// Numbers the nodes in this order (`number`).
std::vector<std::uint32_t> PartDivider::nodes_near_separator(Nodes part) {
    std::vector<std::uint32_t> near;
    std::copy_if(part.begin(), part.end(), std::back_inserter(near), [this](std::uint32_t node) {
        return memory_.zones[node] == Zone::Outside;
    });
    number(near);
    std::size_t begin = 0;
    for (int layer = 0; layer < kRefinedLayers; ++layer) {
        const std::size_t end = near.size();
        for (; begin < end; ++begin) {
            add_unnumbered_neighbors(near[begin], near);
        }
    }
    return near;
}

// Finds the neighbors of a node that are in the zone Low or High and have no number yet, numbers
// them, and appends them to `nodes`. Neighbors in other parts are in the zone Outside and therefore
// not appended.
void PartDivider::add_unnumbered_neighbors(std::uint32_t node, std::vector<std::uint32_t>& nodes) {
    for (const std::uint32_t neighbor : graph_.neighbors_of(node)) {
        std::uint32_t& index = memory_.numbers[neighbor];
        if (memory_.zones[neighbor] != Zone::Outside && index == kNoNumber) {
            index = narrow(nodes.size());
            nodes.push_back(neighbor);
        }
    }
}

void PartDivider::divide_by_graph(Nodes part) {
    assign(part, bisect(graph_of(part)));
}

// Returns the graph of a part: its nodes, numbered in their order, and the edges between them.
WeightedGraph PartDivider::graph_of(Nodes part) {
    number(part);
    WeightedGraph graph;
    for (const std::uint32_t node : part) {
        append_node(node, graph);
    }
    graph.begins.push_back(narrow(graph.edges.size()));
    forget_numbers(part);
    return graph;
}

// Appends to `graph` a node, and those of its edges that lead to numbered nodes. Returns two flags,
// for Low and for High. A flag is true if the node also has neighbors in this zone that have no
// number.
std::array<bool, 2> PartDivider::append_node(std::uint32_t node, WeightedGraph& graph) const {
    std::array<bool, 2> touches_rest{};
    graph.begins.push_back(narrow(graph.edges.size()));
    graph.weights.push_back(nodes_[node].rows);
    for (const std::uint32_t neighbor : graph_.neighbors_of(node)) {
        const std::uint32_t number = memory_.numbers[neighbor];
        const Zone zone = memory_.zones[neighbor];
        if (number != kNoNumber) {
            graph.edges.push_back({number, 1});
        } else if (zone != Zone::Outside) {
            touches_rest[zone == Zone::High ? 1 : 0] = true;
        }
    }
    return touches_rest;
}

// Returns the graph of the nodes in `near`, which are near the separator, and of two additional
// nodes. The first additional node represents all other nodes of the part in the zone Low, the
// second all other nodes in the zone High. Precondition: the nodes in `near` are numbered in their
// order.
WeightedGraph PartDivider::graph_of_near(Nodes near, Nodes part) const {
    WeightedGraph graph;
    std::array<std::vector<WeightedGraph::Edge>, 2> edges_of_rest;
    for (std::size_t k = 0; k < near.size(); ++k) {
        const std::array<bool, 2> touches_rest = append_node(near[k], graph);
        for (std::size_t zone = 0; zone < 2; ++zone) {
            if (touches_rest[zone]) {
                graph.edges.push_back({narrow(near.size() + zone), 1});
                edges_of_rest[zone].push_back({narrow(k), 1});
            }
        }
    }
    for (const Zone zone : {Zone::Low, Zone::High}) {
        const auto& edges = edges_of_rest[zone == Zone::High ? 1 : 0];
        graph.begins.push_back(narrow(graph.edges.size()));
        graph.weights.push_back(rows_of(part, zone) - rows_of(near, zone));
        graph.edges.insert(graph.edges.end(), edges.begin(), edges.end());
    }
    graph.begins.push_back(narrow(graph.edges.size()));
    return graph;
}

// Numbers the nodes in their order: stores their numbers in DivisionMemory::numbers.
void PartDivider::number(Nodes nodes) {
    for (std::size_t k = 0; k < nodes.size(); ++k) {
        memory_.numbers[nodes[k]] = narrow(k);
    }
}

void PartDivider::forget_numbers(Nodes nodes) {
    for (const std::uint32_t node : nodes) {
        memory_.numbers[node] = kNoNumber;
    }
}

// Sets the zone of nodes[k] to zones[k], for all k. Elements of `zones` after those of `nodes` are
// ignored.
void PartDivider::assign(Nodes nodes, std::span<const Zone> zones) {
    for (std::size_t k = 0; k < nodes.size(); ++k) {
        memory_.zones[nodes[k]] = zones[k];
    }
}

int PartDivider::rows_of(Nodes nodes, Zone zone) const {
    int rows = 0;
    for (const std::uint32_t node : nodes) {
        rows += memory_.zones[node] == zone ? nodes_[node].rows : 0;
    }
    return rows;
}

}  // namespace foam
