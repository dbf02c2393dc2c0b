#pragma once

#include "core/geometry/domain.h"
#include "core/sparse/node_graph.h"
#include "core/sparse/separator.h"

#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

namespace foam {

struct DissectionOptions {
    int leaf_rows = 16;  // a part with at most this many rows is not divided
    SeparatorOptions separator{};
};

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

/// Finds an order of elimination by geometric nested dissection (George 1973): divides the nodes at
/// the median of the coordinate in which they extend further, moves that border to the lightest
/// separator near it, and divides both sides in the same way. The separators of a torus consist of
/// two lines at first. Positions are only a guide: the order is valid for any graph. The result is
/// the same for any number of threads, which are meant as in thread_count. Precondition: there is
/// at least one node.
Dissection dissect(const NodeGraph& graph,
                   std::span<const SolverNode> nodes,
                   const Domain& domain,
                   const DissectionOptions& options,
                   int threads = 1);

}  // namespace foam
