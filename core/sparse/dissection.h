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

/// A range of nodes in the order of elimination: the separator between two earlier ranges, or a
/// leaf.
struct DissectionPart {
    static constexpr std::size_t kNoPart = std::numeric_limits<std::size_t>::max();

    std::size_t begin = 0;
    std::size_t end = 0;
    std::size_t left = kNoPart;  // both or none
    std::size_t right = kNoPart;

    bool is_leaf() const { return left == kNoPart; }
};

/// A binary tree of parts. No node of a part's left subtree is coupled to one of its right subtree.
struct Dissection {
    std::vector<std::uint32_t> order;   // nodes in the order of elimination
    std::vector<DissectionPart> parts;  // every part after both its subtrees; the last is the root
};

/// Finds an order of elimination by nested dissection (George 1973): divides the nodes by a light
/// separator, which is eliminated last, and divides both sides in the same way. Positions propose
/// the separators, and the graph decides (PartDivider). Those of a torus consist of two lines at
/// first. The order is valid for any positions, and the same for any number of threads, which are
/// meant as in thread_count. Precondition: there is at least one node.
Dissection dissect(const NodeGraph& graph,
                   std::span<const SolverNode> nodes,
                   const Domain& domain,
                   const DissectionOptions& options,
                   int threads = 1);

}  // namespace foam
