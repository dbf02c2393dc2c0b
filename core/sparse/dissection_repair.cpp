// SPDX-License-Identifier: Apache-2.0

#include "core/sparse/dissection_repair.h"

#include <algorithm>
#include <cassert>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <unordered_map>
#include <vector>

namespace foam {

// An edge is allowed if its two nodes are in the same part, or if the part of one node is an
// ancestor of the other part. If an edge is not allowed, one of its nodes is moved to the lowest
// common ancestor of the two parts. The allowed edges of this node stay allowed for two reasons:
// - The old part of the node and all descendants of the old part are descendants of the new part.
// - Each ancestor of the old part is the new part itself, or an ancestor or a descendant of it.
//
// One pass over the edges is therefore enough, whatever part a new node joins at first.

namespace {

// The tree of a dissection. Parts are given by their indices.
struct PartTree {
    std::vector<std::size_t> parents;
    std::vector<std::size_t> first_descendants;  // the first part of the subtree of each part

    bool is_within(std::size_t part, std::size_t ancestor) const {
        return first_descendants[ancestor] <= part && part <= ancestor;
    }
};

PartTree tree_of(const std::vector<DissectionPart>& parts) {
    PartTree tree{std::vector<std::size_t>(parts.size()), {}};
    for (std::size_t k = 0; k < parts.size(); ++k) {
        const DissectionPart& part = parts[k];
        tree.first_descendants.push_back(part.is_leaf() ? k : tree.first_descendants[part.left]);
        if (!part.is_leaf()) {
            tree.parents[part.left] = k;
            tree.parents[part.right] = k;
        }
    }
    return tree;
}

// Returns the part of each node of the dissection.
std::vector<std::size_t> parts_of_earlier_nodes(const Dissection& dissection) {
    std::vector<std::size_t> part_of(dissection.order.size());
    for (std::size_t k = 0; k < dissection.parts.size(); ++k) {
        const DissectionPart& part = dissection.parts[k];
        for (std::size_t position = part.begin; position < part.end; ++position) {
            part_of[dissection.order[position]] = k;
        }
    }
    return part_of;
}

// Returns the part of each node of the graph before nodes are moved. A new node gets the first, in
// postorder, of the parts that its neighbors have so far, or the root if they have none.
std::vector<std::size_t> first_parts(const Dissection& dissection,
                                     const NodeGraph& graph,
                                     std::span<const std::uint32_t> earlier) {
    const std::vector<std::size_t> earlier_parts = parts_of_earlier_nodes(dissection);
    const std::size_t root = dissection.parts.size() - 1;
    std::vector<std::size_t> part_of(earlier.size(), root);
    for (std::size_t node = 0; node < earlier.size(); ++node) {
        if (earlier[node] != kNoNumber) {
            part_of[node] = earlier_parts[earlier[node]];
        }
    }
    for (std::size_t node = 0; node < earlier.size(); ++node) {
        if (earlier[node] == kNoNumber) {
            for (const std::uint32_t neighbor : graph.neighbors_of(node)) {
                part_of[node] = std::min(part_of[node], part_of[neighbor]);
            }
        }
    }
    return part_of;
}

// For each edge that is not allowed, moves one of its nodes. Nodes are visited from the last to the
// first, because in a foam the nodes of bubbles and outer films are last and have the fewest rows.
void move_nodes(const NodeGraph& graph, const PartTree& tree, std::vector<std::size_t>& part_of) {
    for (std::size_t node = part_of.size(); node-- > 0;) {
        std::size_t& part = part_of[node];
        for (const std::uint32_t neighbor : graph.neighbors_of(node)) {
            const std::size_t other = part_of[neighbor];
            while (!tree.is_within(part, other) && !tree.is_within(other, part)) {
                part = tree.parents[part];
            }
        }
    }
}

// Gives each part its nodes, in descending order, as in a new dissection.
void sort_by_part(const std::vector<std::size_t>& part_of, Dissection& dissection) {
    const auto part_of_node = [&](std::uint32_t node) { return part_of[node]; };
    dissection.order.resize(part_of.size());
    std::iota(dissection.order.rbegin(), dissection.order.rend(), 0U);
    std::ranges::stable_sort(dissection.order, {}, part_of_node);
    std::size_t position = 0;
    for (std::size_t k = 0; k < dissection.parts.size(); ++k) {
        DissectionPart& part = dissection.parts[k];
        part.begin = position;
        while (position < part_of.size() && part_of_node(dissection.order[position]) == k) {
            ++position;
        }
        part.end = position;
    }
}

}  // namespace

std::vector<std::uint32_t> earlier_numbers(std::span<const std::uint64_t> earlier_names,
                                           std::span<const SolverNode> nodes) {
    std::vector<std::uint32_t> numbers(nodes.size());
    if (earlier_names.size() == nodes.size()) {
        std::iota(numbers.begin(), numbers.end(), 0U);
        return numbers;
    }
    std::unordered_map<std::uint64_t, std::uint32_t> earlier;
    earlier.reserve(earlier_names.size());
    for (std::uint32_t number = 0; number < earlier_names.size(); ++number) {
        earlier.try_emplace(earlier_names[number], number);  // keeps the first of equal names
    }
    std::ranges::transform(nodes, numbers.begin(), [&](const SolverNode& node) {
        const auto found = earlier.find(node.name);
        return found == earlier.end() ? kNoNumber : found->second;
    });
    return numbers;
}

void repair(Dissection& dissection,
            const NodeGraph& graph,
            std::span<const std::uint32_t> earlier) {
    assert(!dissection.parts.empty());
    std::vector<std::size_t> part_of = first_parts(dissection, graph, earlier);
    move_nodes(graph, tree_of(dissection.parts), part_of);
    sort_by_part(part_of, dissection);
}

}  // namespace foam
