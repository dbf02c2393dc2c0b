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

/// One element of the tree of a dissection: the nodes [begin, end) of the order of elimination.
/// They are either a leaf (a part of the graph that is not divided further) or the separator of a
/// divided part. The two sides of a separator are its two subtrees, whose nodes are earlier in the
/// order.
struct DissectionPart {
    static constexpr std::size_t kNoPart = std::numeric_limits<std::size_t>::max();

    std::size_t begin = 0;
    std::size_t end = 0;
    std::size_t left = kNoPart;   // index of the left subtree's root; kNoPart if this is a leaf
    std::size_t right = kNoPart;  // the same for the right subtree

    bool is_leaf() const { return left == kNoPart; }
};

/// The result of nested dissection: an order of elimination, divided into a binary tree of
/// DissectionParts. No edge of the graph joins a node of the left subtree of a part to a node of
/// its right subtree.
struct Dissection {
    std::vector<std::uint32_t> order;  // nodes in the order of elimination
    // Every part is stored after both its subtrees; the last one is the root. The nodes of a part
    // are in descending order.
    std::vector<DissectionPart> parts;
};

/// Returns an order of elimination, found by nested dissection (George 1973). A node of the graph
/// represents one or more rows of the matrix (SolverNode::rows). The nodes are divided by a light
/// separator (a separator of few rows), which is eliminated last. Both sides are then divided in
/// the same way, until a part has at most DissectionOptions::leaf_rows rows or one side of its
/// separator would be empty. Separators are found from positions, or from the edges of the graph
/// where positions give heavy separators (PartDivider). On a torus, the separator of the first
/// level consists of two lines, because one closed line does not divide a torus. If one of its
/// sides is a band that closes around the torus, a separator that cuts this band across also
/// consists of two lines.
///
/// Within a leaf or a separator, nodes are eliminated from the highest to the lowest index. The
/// nodes of a foam are numbered so that its outer films and bubbles have the highest indices. (If
/// the junctions of a bubble were eliminated before its pressure, a pivot of the junctions could be
/// nearly zero.)
///
/// The order is valid for any positions, and is the same for any number of threads. `threads` has
/// the same meaning as in thread_count. Precondition: there is at least one node.
Dissection dissect(const NodeGraph& graph,
                   std::span<const SolverNode> nodes,
                   const Domain& domain,
                   const DissectionOptions& options,
                   int threads = 1);

}  // namespace foam
