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

// Symbolic factorization. Each part of the dissection becomes a front. The border of a front is the
// union of the later neighbors of its nodes and the borders of its children, without its own nodes.
// One pass in postorder therefore finds all borders. Then the workspace is laid out, the borders
// are linked to the parent fronts, and each entry of the matrix gets its index in a panel.

namespace {

using Indices = std::vector<std::uint32_t>;

std::vector<std::size_t> first_rows_of(std::span<const SolverNode> nodes) {
    std::vector<std::size_t> first_rows(1, 0);
    for (const SolverNode& node : nodes) {
        first_rows.push_back(first_rows.back() + static_cast<std::size_t>(node.rows));
    }
    return first_rows;
}

// Finds the fronts and their borders. The turn of a node is its index in the order of elimination.
class FrontBuilder {
  public:
    FrontBuilder(const NodeGraph& graph,
                 const Dissection& dissection,
                 std::span<const SolverNode> nodes)
        : graph_(graph), dissection_(dissection) {
        order_rows(nodes);
        seen_by_.assign(nodes.size(), narrow(dissection.parts.size()));
    }

    // Returns the fronts with their borders, or nothing as soon as the factor alone exceeds the
    // limit.
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
    void order_rows(std::span<const SolverNode> nodes) {
        const std::vector<std::size_t> matrix_rows = first_rows_of(nodes);
        plan_.elimination.resize(matrix_rows.back());
        turns_.resize(nodes.size());
        std::size_t row = 0;
        for (const std::uint32_t node : dissection_.order) {
            turns_[node] = narrow(first_rows_.size());
            first_rows_.push_back(row);
            for (std::size_t k = matrix_rows[node]; k < matrix_rows[node + 1]; ++k) {
                plan_.elimination[k] = narrow(row++);
            }
        }
        first_rows_.push_back(row);
    }

    // Finds the border of a part: the later nodes that its nodes are coupled to, directly or
    // through earlier nodes.
    void find_border(const DissectionPart& part) {
        const std::size_t begin = border_turns_.size();
        for (std::size_t turn = part.begin; turn < part.end; ++turn) {
            for (const std::uint32_t neighbor : graph_.of(dissection_.order[turn])) {
                add_to_border(part, turns_[neighbor]);
            }
        }
        if (!part.is_leaf()) {
            inherit_border(part, part.left);
            inherit_border(part, part.right);
        }
        std::sort(border_turns_.begin() + static_cast<std::ptrdiff_t>(begin), border_turns_.end());
        border_begins_.push_back(border_turns_.size());
    }

    void inherit_border(const DissectionPart& part, std::size_t child) {
        for (std::size_t k = border_begins_[child]; k < border_begins_[child + 1]; ++k) {
            add_to_border(part, border_turns_[k]);
        }
    }

    void add_to_border(const DissectionPart& part, std::uint32_t turn) {
        const std::uint32_t present = narrow(plan_.fronts.size());
        if (turn >= part.end && seen_by_[turn] != present) {
            seen_by_[turn] = present;
            border_turns_.push_back(turn);
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
        const std::size_t present = plan_.fronts.size();
        for (std::size_t k = border_begins_[present]; k < border_begins_[present + 1]; ++k) {
            const std::size_t turn = border_turns_[k];
            for (std::size_t row = first_rows_[turn]; row < first_rows_[turn + 1]; ++row) {
                plan_.border_rows.push_back(narrow(row));
            }
        }
    }

    const NodeGraph& graph_;
    const Dissection& dissection_;
    FrontPlan plan_;
    Indices turns_;                        // of each node
    std::vector<std::size_t> first_rows_;  // first row of each turn, and the end of the last
    Indices border_turns_;                 // the borders of all fronts, as turns
    std::vector<std::size_t> border_begins_{0};
    // For each turn, the last front to whose border it was added.
    Indices seen_by_;
};

// Finds the slots of the rows of every border in the parent front.
void link_borders(FrontPlan& plan) {
    plan.border_slots.resize(plan.border_rows.size());
    Indices slots(plan.elimination.size());
    for (const Front& front : plan.fronts) {
        if (front.is_leaf()) {
            continue;
        }
        plan.write_slots(front, slots);
        for (const Front* child : {&plan.fronts[front.left], &plan.fronts[front.right]}) {
            for (std::size_t k = 0; k < child->border; ++k) {
                const std::size_t at = child->border_begin + k;
                plan.border_slots[at] = slots[plan.border_rows[at]];
            }
        }
    }
}

}  // namespace

std::optional<FrontPlan> plan_fronts(const Eigen::SparseMatrix<double>& lower_pattern,
                                     std::span<const SolverNode> nodes,
                                     const Domain& domain,
                                     const DissectionOptions& options,
                                     std::size_t limit,
                                     int threads) {
    const NodeGraph graph = coupling(lower_pattern, nodes);
    const Dissection dissection = dissect(graph, nodes, domain, options, threads);
    std::optional<FrontPlan> plan = FrontBuilder(graph, dissection, nodes).run(limit);
    if (!plan) {
        return std::nullopt;
    }
    plan->workspace_size = share_workspace(plan->fronts);
    if (plan->panels_size + plan->workspace_size > limit) {
        return std::nullopt;
    }
    assert(plan->elimination.size() == static_cast<std::size_t>(lower_pattern.cols()));
    link_borders(*plan);
    locate_entries(lower_pattern, *plan);
    return plan;
}

}  // namespace foam
