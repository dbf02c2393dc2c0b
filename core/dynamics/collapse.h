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

/// Returns true if the bubble is small enough to vanish (E8; paper eq. 3): with three sides at the
/// T2 area; with more, which the paper leaves open, at a tenth of it. Bubbles of six or more sides
/// grow or keep their area.
bool is_due_to_vanish(const Foam& foam, BubbleId bubble, const TopologyThresholds& thresholds);

/// Makes a bubble vanish: its shortest films flip until three sides are left, these become one
/// junction at the mean of the three (T2), and its gas goes to its last neighbors in equal shares.
/// Returns false if no sequence of flips allows it, as between the last bubbles of a torus; the
/// bubble then keeps its gas. A bubble of a raft of two leaves the other one as a lone bubble.
bool collapse(Foam& foam, BubbleId bubble, TopologyCounts& counts);

/// Removes the lone bubbles for which `vanishes(bubble)` holds. Returns their number.
template <class Vanishes>
int collapse_lone(Foam& foam, const Vanishes& vanishes) {
    return static_cast<int>(std::erase_if(foam.lone_bubbles, [&](const LoneBubble& bubble) {
        if (!vanishes(bubble)) {
            return false;
        }
        foam.events.push_back({TopologyEventKind::T2, foam.time, bubble.centre, {bubble.identity}});
        return true;
    }));
}

/// Collapses every bubble that is due, and those that the negative targets of others leave with
/// almost no gas, so that every target is positive; lone bubbles vanish at the T2 area. A bubble
/// that cannot vanish gets a small target area at the cost of its largest neighbor.
TopologyCounts collapse_due(Foam& foam, const TopologyThresholds& thresholds);

}  // namespace foam
