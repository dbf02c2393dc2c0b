// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/sparse/dissection.h"
#include "core/sparse/node_graph.h"

namespace foam {

/// Adapts a dissection of one graph to another graph that has the same nodes and differs only in a
/// few edges. Where an edge joins the two sides of a separator, one node of this edge is moved into
/// the separator. The nodes of each part stay in descending order. A repair is much faster than a
/// new dissection, but the separators grow. Returns false, and leaves the dissection unchanged, if
/// the number of nodes differs.
bool repair(Dissection& dissection, const NodeGraph& graph);

}  // namespace foam
