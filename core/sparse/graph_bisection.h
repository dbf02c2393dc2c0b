// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/sparse/weighted_graph.h"
#include "core/sparse/zone.h"

#include <vector>

namespace foam {

/// Returns the largest weight that a zone should have in a graph of weight `weight`: six tenths of
/// `weight`.
int heaviest_zone(int weight);

/// Divides a graph by a light separator, using its edges alone. Returns the zone of each node. No
/// node of the zone Low is a neighbor of a node of High; the nodes of Outside are the separator.
///
/// The method is multilevel bisection (Karypis and Kumar 1998). Neighbors are merged until at most
/// 100 nodes are left or merging no longer makes the graph much smaller. The coarsest graph is
/// divided by the best of several breadth-first searches. The separator is then refined on each
/// finer graph in turn. The result depends only on the order of nodes and edges. Precondition:
/// there is at least one node.
std::vector<Zone> bisect(const WeightedGraph& graph);

}  // namespace foam
