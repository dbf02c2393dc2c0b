// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/sparse/dissection.h"
#include "core/sparse/node_graph.h"

namespace foam {

/// Adapts a dissection of one graph to another graph of the same nodes, of which only a few edges
/// differ. Where an edge joins the two sides of a separator, one of its nodes is moved into the
/// separator. This is much faster than a new dissection, but the separators grow. Returns false,
/// and leaves the dissection as it was, if the number of nodes differs.
bool repair(Dissection& dissection, const NodeGraph& graph);

}  // namespace foam
