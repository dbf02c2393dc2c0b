// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/geometry/domain.h"
#include "core/sparse/node_graph.h"
#include "core/sparse/zone.h"

#include <cstdint>
#include <span>

namespace foam {

/// A rectangle around the nodes of a part of a graph. On a torus, it may extend beyond the
/// fundamental cell, and contains a node if it contains one of the node's copies. A few nodes may
/// be slightly outside: where the part has been separated from another part, the rectangle ends at
/// the border of the two halves, which the separator does not follow exactly.
struct PartBox {
    Vec2 low = Vec2::Zero();
    Vec2 high = Vec2::Zero();
};

/// The coordinates between which the nodes of Low are. On a torus, they may be outside of the
/// fundamental cell.
struct LowRange {
    double begin = 0.0;
    double end = 0.0;
};

/// Returns the width and the height of the torus, by which x and y are wrapped even if the torus is
/// sheared. For the plane, returns values so large that no coordinate is ever wrapped.
Vec2 periods_of(const Domain& domain);

/// Halves a part of a graph at the median coordinate along an axis: assigns the nodes with the
/// lower coordinates to the zone Low, all others to High. Returns the coordinate of the border
/// between the halves, in the copy of the torus in which the box is.
///
/// Coordinates are taken relative to the middle of the box. On a torus, they are wrapped to at most
/// half a period on either side of the middle. A node slightly beyond an edge of the box thus stays
/// near that edge. A coordinate that is not finite is replaced by the middle. If two coordinates
/// are equal, the node with the smaller index is the lower one.
double halve_at_median(std::span<const std::uint32_t> part,
                       std::span<const SolverNode> nodes,
                       const Vec2& periods,
                       const PartBox& box,
                       Eigen::Index axis,
                       std::span<Zone> zones);

/// Halves a part that extends around the torus along an axis: assigns half of its nodes to the zone
/// Low, all others to High. Both are bands, and the separator of the two halves (separate_halves)
/// is at both borders between them. Low begins where this separator is lightest. (For this choice,
/// a node that has neighbors beyond both borders is counted twice. Only very short or sheared tori
/// have such nodes.) `period` is the length of the torus along the axis. Returns the coordinates of
/// both borders.
LowRange halve_at_lightest_position(std::span<const std::uint32_t> part,
                                    std::span<const SolverNode> nodes,
                                    const NodeGraph& graph,
                                    double period,
                                    Eigen::Index axis,
                                    std::span<Zone> zones);

/// Assigns the separator of two halves to the zone Outside: the nodes of one half that have
/// neighbors in the other half. Of the two halves, uses the one in which these nodes have fewer
/// rows.
void separate_halves(std::span<const std::uint32_t> part,
                     std::span<const SolverNode> nodes,
                     const NodeGraph& graph,
                     std::span<Zone> zones);

}  // namespace foam
