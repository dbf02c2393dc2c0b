// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/geometry/domain.h"
#include "core/sparse/dissection_options.h"
#include "core/sparse/node_graph.h"

#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

namespace foam {

/// A range of nodes in the order of elimination: a leaf, or the separator between two earlier
/// ranges.
struct DissectionPart {
    static constexpr std::size_t kNoPart = std::numeric_limits<std::size_t>::max();

    std::size_t begin = 0;
    std::size_t end = 0;
    std::size_t left = kNoPart;  // index of the left subtree's root; kNoPart if this is a leaf
    std::size_t right = kNoPart;

    bool is_leaf() const { return left == kNoPart; }
};

/// A binary tree of parts. No node of a part's left subtree is coupled to a node of its right
/// subtree.
struct Dissection {
    std::vector<std::uint32_t> order;  // nodes in the order of elimination
    // Every part is stored after both its subtrees; the last one is the root.
    std::vector<DissectionPart> parts;
};

/// Finds an order of elimination by nested dissection (George 1973): divides the nodes by a light
/// separator, which is eliminated last, and then divides both sides in the same way. Separators are
/// proposed by positions and checked against the graph (PartDivider). The first separators of a
/// torus consist of two lines each, since one line divides neither a torus nor a band around it.
///
/// The order is valid for any positions. It is the same for any number of threads. `threads` has
/// the same meaning as in thread_count. Precondition: there is at least one node.
Dissection dissect(const NodeGraph& graph,
                   std::span<const SolverNode> nodes,
                   const Domain& domain,
                   const DissectionOptions& options,
                   int threads = 1);

}  // namespace foam
