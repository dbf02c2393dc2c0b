#pragma once

#include "core/sparse/weighted_graph.h"
#include "core/sparse/zone.h"

#include <vector>

namespace foam {

/// Returns the most that a zone of a graph of this weight should hold: six tenths.
int heaviest_zone(int weight);

/// Divides a graph by a light separator, from its edges alone: returns each node's zone. No node of
/// the zone Low is a neighbor of one of High; Outside is the separator.
///
/// This is multilevel bisection (Karypis and Kumar 1998): neighbors are merged until some hundred
/// nodes are left; that graph is divided by the best of several breadth-first searches; and the
/// separator is refined on each finer graph in turn. The result depends on the order of nodes and
/// edges only. Precondition: there is at least one node.
std::vector<Zone> bisect(const WeightedGraph& graph);

}  // namespace foam
