#pragma once

#include "core/geometry/domain.h"
#include "core/sparse/node_graph.h"

#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

namespace foam {

struct DissectionOptions {
    int leaf_rows = 16;       // a part of so many rows is not cut further
    int band_layers = 1;      // the cut is sought among so many layers of nodes on either side
    double band_share = 0.4;  // ... that hold at most so much of the side
};

/// A range of nodes in the order of elimination: those that part two earlier ranges from each
/// other, or a leaf.
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

/// Geometric nested dissection: halves the nodes at the median of the coordinate in which they
/// extend further, moves that cut to the lightest one near it, and goes on with either side.
/// Two such cuts part a torus, one the plane. Positions only guide it: any graph will do. Needs one
/// node at least. The same for any number of threads.
Dissection dissect(const NodeGraph& graph,
                   std::span<const SolverNode> nodes,
                   const Domain& domain,
                   const DissectionOptions& options,
                   int threads = 1);

}  // namespace foam
