// SPDX-License-Identifier: Apache-2.0

#include "core/sparse/dissection_repair.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace foam {

// An edge is allowed if the part of one of its nodes is an ancestor of the part of the other, or
// the same part. The node of a forbidden edge that is moved goes to the lowest common ancestor of
// the two parts. All its allowed edges stay allowed: an ancestor of its old part is an ancestor or
// a descendant of its new part, and a descendant of its old part is a descendant of its new part.
// One pass over the edges is therefore enough.

namespace {

class DissectionRepair {
  public:
    DissectionRepair(const Dissection& dissection, const NodeGraph& graph)
        : parts_(dissection.parts), order_(dissection.order), graph_(graph) {
        const std::size_t count = parts_.size();
        parents_.assign(count, count - 1);
        first_descendants_.resize(count);
        part_of_node_.resize(order_.size());
        for (std::size_t k = 0; k < count; ++k) {
            const DissectionPart& part = parts_[k];
            first_descendants_[k] = part.is_leaf() ? k : first_descendants_[part.left];
            if (!part.is_leaf()) {
                parents_[part.left] = k;
                parents_[part.right] = k;
            }
            for (std::size_t position = part.begin; position < part.end; ++position) {
                part_of_node_[order_[position]] = k;
            }
        }
    }

    // Moves a node of each forbidden edge. The nodes of bubbles follow those of junctions and have
    // fewer rows, so the nodes are visited from the last to the first.
    void move_nodes() {
        for (std::size_t node = part_of_node_.size(); node-- > 0;) {
            for (const std::uint32_t neighbor : graph_.neighbors_of(node)) {
                while (!is_allowed(part_of_node_[node], part_of_node_[neighbor])) {
                    part_of_node_[node] = parents_[part_of_node_[node]];
                }
            }
        }
    }

    // Returns the same tree with the moved nodes; nodes that were in one part keep their order.
    Dissection result() const {
        std::vector<std::vector<std::uint32_t>> nodes(parts_.size());
        for (const std::uint32_t node : order_) {
            nodes[part_of_node_[node]].push_back(node);
        }
        Dissection repaired;
        for (std::size_t k = 0; k < parts_.size(); ++k) {
            const std::size_t begin = repaired.order.size();
            repaired.order.insert(repaired.order.end(), nodes[k].begin(), nodes[k].end());
            repaired.parts.push_back(
                {begin, repaired.order.size(), parts_[k].left, parts_[k].right});
        }
        return repaired;
    }

  private:
    // Returns true if the part `below` is in the tree whose root is the part `above`.
    bool is_within(std::size_t below, std::size_t above) const {
        return first_descendants_[above] <= below && below <= above;
    }

    bool is_allowed(std::size_t a, std::size_t b) const {
        return is_within(a, b) || is_within(b, a);
    }

    const std::vector<DissectionPart>& parts_;
    const std::vector<std::uint32_t>& order_;
    const NodeGraph& graph_;
    std::vector<std::size_t> parents_;            // per part
    std::vector<std::size_t> first_descendants_;  // per part: its first descendant, or itself
    std::vector<std::size_t> part_of_node_;
};

}  // namespace

bool repair(Dissection& dissection, const NodeGraph& graph) {
    if (dissection.order.size() + 1 != graph.begins.size()) {
        return false;
    }
    DissectionRepair nodes(dissection, graph);
    nodes.move_nodes();
    dissection = nodes.result();
    return true;
}

}  // namespace foam
