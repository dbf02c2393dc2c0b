// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/sparse/dissection.h"
#include "core/sparse/node_graph.h"

#include <cstdint>
#include <span>
#include <vector>

namespace foam {

/// For each node of a matrix, finds the node of an earlier matrix that represents the same
/// unknowns. Returns the number of this earlier node, or kNoNumber if there is none. If both
/// matrices have the same number of nodes, these are assumed to be the same in the same order;
/// otherwise they are compared by name. The elements of `earlier_names` are the names of the
/// earlier nodes (SolverNode::name).
std::vector<std::uint32_t> earlier_numbers(std::span<const std::uint64_t> earlier_names,
                                           std::span<const SolverNode> nodes);

/// Adapts a dissection of one graph to another graph that differs from it in a few nodes and edges.
/// `earlier` is the result of earlier_numbers for the nodes of `graph`. At first, a node keeps
/// its part, and a new node joins a part of its neighbors. Where an edge joins the two sides of a
/// separator, one node of this edge is moved into the separator. The nodes of each part are in
/// descending order again. A repair is much faster than a new dissection, but the separators grow,
/// and parts may become empty.
void repair(Dissection& dissection, const NodeGraph& graph, std::span<const std::uint32_t> earlier);

}  // namespace foam
