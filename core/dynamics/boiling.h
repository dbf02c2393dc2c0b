// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/foam/foam.h"
#include "core/foam/random.h"

#include <optional>
#include <set>
#include <vector>

namespace foam {

/// A bubble that vanishes once in each cycle (E9). About a tenth of a cycle later it is born again,
/// with the same identity.
struct BoilingBubble {
    BubbleIdentity identity = 0;
    // The position in the cycle, from 0 to steps - 1, directly before the bubble appears. The
    // bubble is absent at this position and present at the next one.
    int birth = 0;
    double area_rise = 0.0;      // largest rise of the target area above `first_area` (area_at)
    double min_area_rise = 0.0;  // Cycle::calm does not reduce area_rise below this area
    // The point at which the bubble last vanished. Before the bubble has vanished for the first
    // time, this is the mean position of the junctions that it had when it was chosen.
    Vec2 last_position{0.0, 0.0};
    // The bubbles between which the bubble last vanished. The set is empty if it vanished as a lone
    // bubble. The value is std::nullopt until the bubble has vanished for the first time.
    std::optional<std::set<BubbleIdentity>> neighbors{};
    // False if the bubble has vanished between the same bubbles the last two times.
    bool neighbors_changed = true;
};

/// Chooses the given fraction of the bubbles of a foam, at least one bubble, so that they are far
/// from each other. The cycle, which has `steps` steps, is divided into as many equal parts as
/// bubbles are chosen. In each part one of the bubbles is born, at a random step. The area rise of
/// a bubble is `rise` times its present target area. Lone bubbles are neither counted nor chosen;
/// if all bubbles are lone bubbles, the result is empty.
std::vector<BoilingBubble> choose_boiling_bubbles(
    const Foam& foam, double fraction, double rise, int steps, Random& random);

/// Returns the target area of the bubble at a position of a cycle with the given number of steps,
/// or nothing if the bubble is absent. Positions from `steps` on belong to later cycles. The bubble
/// is present for nine tenths of the cycle. In this time its target area rises from `first_area` to
/// `first_area` + `area_rise` and falls back. Preconditions: `first_area` is above the T2 area
/// (E8), and the position is not negative.
std::optional<double> area_at(const BoilingBubble& bubble,
                              int position,
                              int steps,
                              double first_area);

/// Adds the bubble to the foam with the given target area. It is born at the junction at which the
/// bubbles of BoilingBubble::neighbors meet. If there are several such junctions, the junction
/// nearest to BoilingBubble::last_position is taken. If there is none, the nearest of all junctions
/// is taken. Returns false and changes nothing if the surrounding bubbles have too little gas
/// (nucleate_at_junction), or if the foam has no junction, because all bubbles are lone bubbles.
bool give_birth(Foam& foam, const BoilingBubble& bubble, double area);

/// Records where the bubble has vanished. `translation` is the vector by which the foam has been
/// moved since the event. Precondition: the event is the T2 of this bubble.
void record_end(BoilingBubble& bubble, const TopologyEvent& event, const Vec2& translation);

}  // namespace foam
