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

/// Returns true if the target area of the bubble is small enough to vanish (E8; paper eq. 3): at
/// most the T2 area for two or three sides, a tenth of it for more, a case that the paper leaves
/// open. Gas diffusion makes no bubble of six or more sides shrink.
bool is_due_to_vanish(const Foam& foam, BubbleId bubble, const TopologyThresholds& thresholds);

/// Makes a bubble vanish. Its shortest films flip until it can vanish with three (or two) sides.
/// Three sides become one junction at the mean of the three (T2), and the gas goes to the last
/// neighbors in equal shares. Returns false if no sequence of flips was found, for example between
/// the last bubbles of a torus; the bubble then keeps its gas. If the bubble is one of a raft of
/// two, the other becomes a lone bubble.
bool collapse(Foam& foam, BubbleId bubble, TopologyCounts& counts);

/// Removes the lone bubbles for which `vanishes(bubble)` holds. Returns their number.
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

/// Collapses every bubble that is due to vanish. A vanished bubble with a negative target area
/// takes gas from its neighbors; those that it leaves with almost none collapse too, until every
/// target area is positive. Lone bubbles vanish at the T2 area. A bubble that cannot vanish gets a
/// small target area at the cost of its largest neighbor.
TopologyCounts collapse_due(Foam& foam, const TopologyThresholds& thresholds);

}  // namespace foam
