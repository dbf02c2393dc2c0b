// SPDX-License-Identifier: Apache-2.0

#include "core/sparse/part_divider.h"

#include "core/geometry/narrow.h"
#include "core/sparse/graph_bisection.h"
#include "core/sparse/separator_refinement.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <utility>

namespace foam {

// Dividing a part puts each of its nodes into a zone: Low or High, the two sides, or Outside, the
// separator. (Nodes of other parts are in Outside, too.)
//
// A part is halved at the median coordinate along the longer axis of its box. The nodes of one half
// that have neighbors in the other half are a separator. In a part of many rows, the separator is
// then refined: moved through the nodes near it (SeparatorRefinement). If the separator has too
// many rows before or after refinement (DissectionOptions), the part is divided by multilevel
// bisection instead.

namespace {

// Refinement may move a separator through this many layers of nodes on each side of it.
constexpr int kRefinedLayers = 6;

// Returns the width and the height of the torus, by which x and y are wrapped even if the torus is
// sheared. For the plane, returns values so large that no coordinate is ever wrapped.
Vec2 periods_of(const Domain& domain) {
    return domain.is_plane() ? Vec2(Vec2::Constant(std::numeric_limits<double>::max()))
                             : Vec2(domain.width, domain.height);
}

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
        ZoneBoxes boxes = divide_by_position(part, *box);
        const double root = std::sqrt(rows);
        if (rows_of(part, Zone::Outside) <= options_.heaviest_separator * root) {
            if (rows < options_.min_refined_rows) {
                return boxes;
            }
            refine(part, rows);
            if (rows_of(part, Zone::Outside) <= options_.heaviest_refined * root) {
                return boxes;
            }
        }
    }
    divide_by_graph(part);
    return {};
}

ZoneBoxes PartDivider::divide_by_position(Nodes part, const PartBox& box) {
    const Eigen::Index axis = box.high.x() - box.low.x() < box.high.y() - box.low.y() ? 1 : 0;
    const double cut = split_at_median(part, box, axis);
    separate_halves(part);
    PartBox low_box = box;
    PartBox high_box = box;
    low_box.high[axis] = high_box.low[axis] = cut;
    return {low_box, high_box};
}

// Makes the separator of two halves: the nodes of one half that have neighbors in the other half.
// Of the two halves, uses the one in which these nodes have fewer rows.
void PartDivider::separate_halves(Nodes part) {
    std::array<std::vector<std::uint32_t>, 2> rims;
    std::array<int, 2> weights{};
    for (const std::uint32_t node : part) {
        const Zone zone = memory_.zones[node];
        const auto neighbors = graph_.neighbors_of(node);
        if (std::any_of(neighbors.begin(), neighbors.end(), [&](std::uint32_t neighbor) {
                return memory_.zones[neighbor] == opposite(zone);
            })) {
            const std::size_t half = zone == Zone::High ? 1 : 0;
            rims[half].push_back(node);
            weights[half] += nodes_[node].rows;
        }
    }
    for (const std::uint32_t node : rims[weights[1] < weights[0] ? 1 : 0]) {
        memory_.zones[node] = Zone::Outside;
    }
}

// Assigns the half of the part with the lower coordinates to Low and the other half to High.
// Returns the coordinate of the border between the halves. Coordinates are taken relative to the
// middle of the box. On a torus, they are wrapped to at most half a period on either side of the
// middle, so that a node slightly beyond an edge of the box stays near that edge. A coordinate that
// is not finite is replaced by the middle.
double PartDivider::split_at_median(Nodes part, const PartBox& box, Eigen::Index axis) {
    std::vector<double>& keys = memory_.keys;
    const double middle = 0.5 * (box.low[axis] + box.high[axis]);
    for (const std::uint32_t node : part) {
        const double from_middle = nodes_[node].position[axis] - middle;
        const double key = from_middle - periods_[axis] * std::round(from_middle / periods_[axis]);
        keys[node] = std::isfinite(key) ? key : 0.0;
    }
    const std::size_t half = part.size() / 2;
    std::nth_element(part.begin(),
                     part.begin() + static_cast<std::ptrdiff_t>(half),
                     part.end(),
                     [&keys](std::uint32_t a, std::uint32_t b) {
                         return std::pair(keys[a], a) < std::pair(keys[b], b);
                     });
    for (std::size_t k = 0; k < part.size(); ++k) {
        memory_.zones[part[k]] = k < half ? Zone::Low : Zone::High;
    }
    return middle + keys[part[half]];
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
    SeparatorRefinement(graph, heaviest_zone(rows), zones).run();
    move_rest(part, zones[near.size()], zones[near.size() + 1]);
    forget_numbers(near);
    assign(near, zones);
}

// Sets the zones of those nodes of a part that have no number. Refinement does not see these nodes
// one by one: in its graph (graph_of_near), one node represents all of them in Low, and another
// node all of them in High. `low` and `high` are the zones of these two nodes after refinement.
void PartDivider::move_rest(Nodes part, Zone low, Zone high) {
    for (const std::uint32_t node : part) {
        if (memory_.part_indices[node] == DivisionMemory::kNotInPart) {
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
        std::uint32_t& index = memory_.part_indices[neighbor];
        if (memory_.zones[neighbor] != Zone::Outside && index == DivisionMemory::kNotInPart) {
            index = narrow(nodes.size());
            nodes.push_back(neighbor);
        }
    }
}

void PartDivider::divide_by_graph(Nodes part) {
    std::sort(part.begin(), part.end());
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
        const std::uint32_t number = memory_.part_indices[neighbor];
        const Zone zone = memory_.zones[neighbor];
        if (number != DivisionMemory::kNotInPart) {
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

// Numbers the nodes in their order: stores their numbers in DivisionMemory::part_indices.
void PartDivider::number(Nodes nodes) {
    for (std::size_t k = 0; k < nodes.size(); ++k) {
        memory_.part_indices[nodes[k]] = narrow(k);
    }
}

void PartDivider::forget_numbers(Nodes nodes) {
    for (const std::uint32_t node : nodes) {
        memory_.part_indices[node] = DivisionMemory::kNotInPart;
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
