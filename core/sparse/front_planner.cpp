// SPDX-License-Identifier: Apache-2.0

#include "core/sparse/front_planner.h"

#include "core/geometry/narrow.h"
#include "core/sparse/front_entries.h"
#include "core/sparse/front_workspace.h"
#include "core/sparse/partial_ldlt.h"

#include <algorithm>
#include <cassert>
#include <utility>

namespace foam {

// This is the symbolic factorization. Each part of the dissection becomes a front. The border of a
// front consists of nodes that come after the front's own nodes in the order of elimination. They
// are the later nodes among the neighbors of its own nodes, and the later nodes in the borders of
// its children. One pass in postorder therefore finds all borders. The columns of L are found in
// this way in J. W. H. Liu, The role of elimination trees in sparse factorization, SIAM Journal on
// Matrix Analysis and Applications 11, 1990. Three more steps follow:
// - The workspace is laid out.
// - Each row of a border gets its slot in the parent front (FrontPlan::write_slots).
// - Each entry of the matrix gets its index in the panel of its front. The panel consists of the
//   columns of the front's pivots.

namespace {

using Indices = std::vector<std::uint32_t>;

// Returns the first matrix row of each node, followed by the number of all rows.
std::vector<std::size_t> first_rows_of(std::span<const SolverNode> nodes) {
    std::vector<std::size_t> first_rows(1, 0);
    for (const SolverNode& node : nodes) {
        first_rows.push_back(first_rows.back() + static_cast<std::size_t>(node.rows));
    }
    return first_rows;
}

// Finds the fronts and their borders. The position of a node is its index in the order of
// elimination.
class FrontBuilder {
  public:
    FrontBuilder(const NodeGraph& graph,
                 const Dissection& dissection,
                 std::span<const SolverNode> nodes)
        : graph_(graph), dissection_(dissection) {
        order_rows(nodes);
        last_front_of_.assign(nodes.size(), narrow(dissection.parts.size()));
    }

    // Returns a plan with the fronts and their borders. Returns std::nullopt as soon as the factor
    // alone exceeds the limit.
    std::optional<FrontPlan> run(std::size_t limit) && {
        for (const DissectionPart& part : dissection_.parts) {
            find_border(part);
            add_front(part);
            if (plan_.panels_size > limit) {
                return std::nullopt;
            }
        }
        return std::move(plan_);
    }

  private:
    // Finds the position of each node and the index of each matrix row in the order of elimination.
    // Also finds, for each position, the index of the first row of its node.
    void order_rows(std::span<const SolverNode> nodes) {
        const std::vector<std::size_t> matrix_rows = first_rows_of(nodes);
        plan_.position_of_row.resize(matrix_rows.back());
        position_of_node_.resize(nodes.size());
        std::size_t row = 0;
        for (const std::uint32_t node : dissection_.order) {
            position_of_node_[node] = narrow(first_rows_.size());
            first_rows_.push_back(row);
            for (std::size_t k = matrix_rows[node]; k < matrix_rows[node + 1]; ++k) {
                plan_.position_of_row[k] = narrow(row++);
            }
        }
        first_rows_.push_back(row);
    }

    // Finds the border of a part: the later nodes to which its nodes are coupled, directly or
    // through earlier nodes.
    void find_border(const DissectionPart& part) {
        const std::size_t begin = border_positions_.size();
        for (std::size_t position = part.begin; position < part.end; ++position) {
            for (const std::uint32_t neighbor : graph_.neighbors_of(dissection_.order[position])) {
                add_to_border(part, position_of_node_[neighbor]);
            }
        }
        if (!part.is_leaf()) {
            inherit_border(part, part.left);
            inherit_border(part, part.right);
        }
        std::sort(border_positions_.begin() + static_cast<std::ptrdiff_t>(begin),
                  border_positions_.end());
        border_begins_.push_back(border_positions_.size());
    }

    void inherit_border(const DissectionPart& part, std::size_t child) {
        for (std::size_t k = border_begins_[child]; k < border_begins_[child + 1]; ++k) {
            add_to_border(part, border_positions_[k]);
        }
    }

    void add_to_border(const DissectionPart& part, std::uint32_t position) {
        const std::uint32_t current_front = narrow(plan_.fronts.size());
        if (position >= part.end && last_front_of_[position] != current_front) {
            last_front_of_[position] = current_front;
            border_positions_.push_back(position);
        }
    }

    // Adds the front of the part whose border was found last.
    void add_front(const DissectionPart& part) {
        Front front;
        front.first_row = first_rows_[part.begin];
        front.pivots = first_rows_[part.end] - front.first_row;
        front.first_descendant = plan_.fronts.size();
        if (!part.is_leaf()) {
            front.left = part.left;
            front.right = part.right;
            front.first_descendant = plan_.fronts[part.left].first_descendant;
        }
        front.border_begin = plan_.border_rows.size();
        add_border_rows();
        front.border = plan_.border_rows.size() - front.border_begin;
        front.panel_begin = plan_.panels_size;
        plan_.panels_size += front.pivots * front.rows();
        plan_.largest_border = std::max(plan_.largest_border, front.border);
        plan_.scratch_size = std::max(plan_.scratch_size, ldlt_scratch(front.pivots, front.border));
        plan_.fronts.push_back(front);
    }

    void add_border_rows() {
        const std::size_t current_front = plan_.fronts.size();
        for (std::size_t k = border_begins_[current_front]; k < border_begins_[current_front + 1];
             ++k) {
            const std::size_t position = border_positions_[k];
            for (std::size_t row = first_rows_[position]; row < first_rows_[position + 1]; ++row) {
                plan_.border_rows.push_back(narrow(row));
            }
        }
    }

    const NodeGraph& graph_;
    const Dissection& dissection_;
    FrontPlan plan_;
    Indices position_of_node_;
    // The first row of the node at each position, followed by the number of all rows.
    std::vector<std::size_t> first_rows_;
    Indices border_positions_;  // the borders of all fronts, as positions of nodes
    std::vector<std::size_t> border_begins_{0};
    Indices last_front_of_;  // for each position, the last front to whose border it was added
};

// Finds, for every border, the slots of its rows in the parent front.
void link_borders(FrontPlan& plan) {
    plan.border_slots.resize(plan.border_rows.size());
    Indices slots(plan.position_of_row.size());
    for (const Front& front : plan.fronts) {
        if (front.is_leaf()) {
            continue;
        }
        plan.write_slots(front, slots);
        for (const Front* child : {&plan.fronts[front.left], &plan.fronts[front.right]}) {
            for (std::size_t k = 0; k < child->border; ++k) {
                const std::size_t index = child->border_begin + k;
                plan.border_slots[index] = slots[plan.border_rows[index]];
            }
            // All rows of the child's border are rows of `front`; otherwise, a separator would not
            // separate its two sides. Both lists of rows increase, and so do the slots.
            [[maybe_unused]] const std::span<const std::uint32_t> child_slots =
                plan.slots_of_border(*child);
            assert(std::is_sorted(child_slots.begin(), child_slots.end()));
        }
    }
}

}  // namespace

std::optional<FrontPlan> plan_fronts(const Eigen::SparseMatrix<double>& lower_pattern,
                                     std::span<const SolverNode> nodes,
                                     const NodeGraph& graph,
                                     const Dissection& dissection,
                                     std::size_t limit) {
    std::optional<FrontPlan> plan = FrontBuilder(graph, dissection, nodes).run(limit);
    if (!plan) {
        return std::nullopt;
    }
    plan->workspace_size = share_workspace(plan->fronts);
    if (plan->panels_size + plan->workspace_size > limit) {
        return std::nullopt;
    }
    assert(plan->position_of_row.size() == static_cast<std::size_t>(lower_pattern.cols()));
    link_borders(*plan);
    locate_entries(lower_pattern, *plan);
    return plan;
}

}  // namespace foam
