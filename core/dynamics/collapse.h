// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/foam/foam.h"
#include "core/foam/topology_thresholds.h"

#include <vector>

namespace foam {

/// Numbers of T1s and T2s.
struct TopologyCounts {
    int t1 = 0;
    int t2 = 0;
};

/// Returns true if the target area of the bubble is so small that the bubble has to vanish (E8;
/// paper eq. 3). The limit is the T2 area for bubbles of two or three sides, and a tenth of it for
/// bubbles of more sides, which the paper does not discuss. Gas diffusion does not shrink bubbles
/// of six or more sides.
bool is_due_to_vanish(const Foam& foam, BubbleId bubble, const TopologyThresholds& thresholds);

/// Makes a bubble vanish. Its shortest films flip until it can vanish with three or two sides (T2).
/// A bubble of three sides becomes one junction at the mean of its three junctions. Its gas goes to
/// its last neighbors in equal shares. Returns false if no sequence of flips was found, for example
/// among the last bubbles of a torus; the bubble then keeps its gas. In a raft of two bubbles, the
/// other bubble becomes a lone bubble.
bool collapse(Foam& foam, BubbleId bubble, TopologyCounts& counts);

/// Removes the lone bubbles for which `vanishes(bubble)` returns true. Returns their number.
template <class Vanishes>
int collapse_lone(Foam& foam, const Vanishes& vanishes) {
    return static_cast<int>(std::erase_if(foam.lone_bubbles, [&](const LoneBubble& bubble) {
        if (!vanishes(bubble)) {
            return false;
        }
        foam.events.push_back({TopologyEventKind::T2, foam.time, bubble.center, {bubble.identity}});
        return true;
    }));
}

/// Collapses every bubble that is due to vanish (is_due_to_vanish). A vanished bubble with a
/// negative target area takes gas from its neighbors. Neighbors that are left with almost no gas
/// collapse too, until every target area is positive. Lone bubbles vanish at the T2 area. A bubble
/// that cannot vanish gets a small target area at the cost of its largest neighbor.
TopologyCounts collapse_due(Foam& foam, const TopologyThresholds& thresholds);

}  // namespace foam
