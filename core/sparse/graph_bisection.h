// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/sparse/weighted_graph.h"
#include "core/sparse/zone.h"

#include <vector>

namespace foam {

/// Returns the largest weight that a zone should have in a graph of total weight `weight`. The
/// zones are Low and High, the two sides of a separator (zone.h). The result is six tenths of
/// `weight`, rounded down to a multiple of 3.
int max_zone_weight(int weight);

/// Divides a graph by a light separator: nodes of small total weight whose removal leaves two sides
/// without edges between them. Uses only the graph, not the positions of its nodes.
/// Returns the zone of each node. The nodes in Outside are the separator; no node in Low is a
/// neighbor of a node in High.
///
/// The method is multilevel bisection (Karypis and Kumar 1998). Neighbors are merged until at most
/// 100 nodes are left or merging would reduce the number of nodes by less than a tenth. The
/// coarsest graph is divided by breadth-first search, from up to four start nodes in turn, and the
/// best of these divisions is kept. The separator is then refined on each finer graph in turn. The
/// result depends only on the graph, including the order of its nodes and edges. Precondition:
/// there is at least one node.
std::vector<Zone> bisect(const WeightedGraph& graph);

}  // namespace foam
