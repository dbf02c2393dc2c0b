#pragma once

#include "core/foam/topology_thresholds.h"
#include "core/foam/foam.h"

#include <vector>

namespace foam {

/// How many T1 and T2 something took.
struct TopologyCounts {
    int t1 = 0;
    int t2 = 0;
};

/// Whether the bubble is small enough to vanish (E8; paper eq. 3): three-sided at the T2 area; with
/// four or five sides, which the paper leaves open, at a tenth of it. Others grow or keep their
/// area.
bool is_due_to_vanish(const Foam& foam, BubbleId bubble, const TopologyThresholds& thresholds);

/// Makes a bubble vanish: its shortest films flip until three sides are left, these become one
/// junction at the mean of the three (T2), and its gas goes to its last neighbours in equal shares.
/// False where no order of flips allows it, as between the last bubbles of a torus; the bubble then
/// keeps what it has. A bubble of a raft of two leaves the other one behind as a lone bubble.
bool collapse(Foam& foam, BubbleId bubble, TopologyCounts& counts);

/// Makes the lone bubbles vanish of which `vanishes(bubble)` holds; returns their number.
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

/// Collapses every bubble that is due, and those that the debts of others leave with next to
/// nothing, so that every target is positive; lone bubbles vanish at the T2 area. A bubble that
/// cannot vanish is left with a small target area at the cost of its largest neighbour.
TopologyCounts collapse_due(Foam& foam, const TopologyThresholds& thresholds);

}  // namespace foam
