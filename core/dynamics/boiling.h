// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/foam/foam.h"
#include "core/foam/random.h"

#include <optional>
#include <set>
#include <vector>

namespace foam {

/// A bubble that vanishes once in each cycle and is born again later in the cycle (E9). All its
/// lives have the same identity.
struct BoilingBubble {
    BubbleIdentity identity = 0;
    int birth = 0;           // position in the cycle, 0 to steps - 1, at which the bubble is absent
                             // for the last time before its birth
    double peak_area = 0.0;  // largest target area in a life
    double floor = 0.0;      // calming reduces the peak area at most to this area
    // Where the bubble vanished last and, after its first end, the bubbles that met there.
    Vec2 place{0.0, 0.0};
    std::set<BubbleIdentity> neighbors{};
    bool moved = true;  // true if its last two ends were between different bubbles
};

/// Chooses the given fraction of the bubbles of a foam, at least one bubble, so that they are far
/// from each other. Their births are evenly distributed over the steps of the cycle. The initial
/// places are the centers of the bubbles.
std::vector<BoilingBubble> choose_boiling_bubbles(const Foam& foam,
                                                  double fraction,
                                                  int steps,
                                                  Random& random);

/// Returns the target area of the bubble at a position of a cycle with the given number of steps,
/// or nothing if the bubble is absent. Nine tenths of the cycle are its life, in which its area
/// rises from `first_area` to `first_area` + `peak_area` and falls back. `first_area` must be above
/// the T2 area (E8).
std::optional<double> area_at(const BoilingBubble& bubble,
                              int position,
                              int steps,
                              double first_area);

/// Adds the bubble to the foam with the given target area. It is born at the junction between the
/// bubbles where it has vanished; if there are several such junctions, at the one nearest to its
/// place, and if there is none, at the junction nearest to its place. Returns false and changes
/// nothing if the surrounding bubbles have too little gas (nucleate_at_junction).
bool give_birth(Foam& foam, const BoilingBubble& bubble, double area);

/// Records where the bubble has vanished. `translation` is the vector by which the foam was moved
/// since then. Precondition: the event is the T2 of this bubble.
void record_end(BoilingBubble& bubble, const TopologyEvent& event, const Vec2& translation);

}  // namespace foam
