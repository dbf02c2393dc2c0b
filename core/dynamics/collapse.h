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
/// paper eq. 3). The limit is the T2 area for bubbles of two or three sides, and a tenth of the T2
/// area for bubbles of more sides. The paper gives no limit for bubbles of more sides, although gas
/// diffusion makes bubbles of four and five sides shrink, too.
bool is_due_to_vanish(const Foam& foam, BubbleId bubble, const TopologyThresholds& thresholds);

/// Makes a bubble vanish. First its shortest films flip, until it has three or two sides and can
/// vanish by a T2 (can_vanish). A bubble of three sides becomes one junction at the mean of its
/// three junctions. The gas of the bubble is divided equally among its sides before the T2, and
/// each share goes to the bubble across the side. In a raft of two bubbles, the other bubble
/// becomes a lone bubble and gets half of the gas; the ghost gets the other half. Returns false if
/// the flips do not make the bubble able to vanish, for example among the last bubbles of a torus.
/// The bubble then keeps its gas, and the flips are not undone. Adds the T1s and T2s to `counts`.
bool collapse(Foam& foam, BubbleId bubble, TopologyCounts& counts);

/// Removes the lone bubbles for which `vanishes(bubble)` returns true, and records a T2 of each.
/// Returns their number.
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

/// Collapses every bubble that is due to vanish (is_due_to_vanish). If the target area of a
/// vanishing bubble is negative, its neighbors lose gas to it. Bubbles that are left with less than
/// a tenth of the T2 area then collapse too; this is repeated until no further bubble vanishes.
/// Lone bubbles vanish at the T2 area. The target area of a bubble that cannot vanish is raised to
/// at least a tenth of the T2 area, at the cost of its largest neighbor. Returns the numbers of T1s
/// and T2s.
TopologyCounts collapse_due(Foam& foam, const TopologyThresholds& thresholds);

}  // namespace foam
