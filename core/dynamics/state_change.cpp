// SPDX-License-Identifier: Apache-2.0

#include "core/dynamics/state_change.h"

#include <algorithm>
#include <map>
#include <vector>

namespace foam {

namespace {

// Largest fraction of a torus that driven bubbles may take if there are other bubbles.
constexpr double kMaxDrivenFraction = 0.9;
// Largest gain of area of a driven bubble in one substep, in units of its present target area.
constexpr double kMaxGain = 3.0;

struct LiveDrivenBubble {
    BubbleId bubble;
    DrivenBubble driven;
};

// Returns the driven bubbles that are still in the network, in the order of StateChange::driven.
std::vector<LiveDrivenBubble> live_driven_bubbles(const Foam& foam, const StateChange& change) {
    if (change.empty()) {
        return {};
    }
    std::map<BubbleIdentity, BubbleId> bubbles;
    for (const BubbleId bubble : foam.network.bubbles()) {
        bubbles[foam.identities[bubble]] = bubble;
    }
    std::vector<LiveDrivenBubble> live;
    for (const DrivenBubble& driven : change.driven) {
        if (const auto found = bubbles.find(driven.bubble); found != bubbles.end()) {
            live.push_back({found->second, driven});
        }
    }
    return live;
}

// Returns the entry of the bubble in StateChange::driven, or nullptr if the bubble is not driven.
const DrivenBubble* find_driven(const StateChange& change, BubbleIdentity bubble) {
    const auto found =
        std::find_if(change.driven.begin(), change.driven.end(), [&](const DrivenBubble& driven) {
            return driven.bubble == bubble;
        });
    return found != change.driven.end() ? &*found : nullptr;
}

// Changes the target areas of driven lone bubbles, as `drive` changes those of driven bubbles of
// the network.
void drive_lone(Foam& foam, const StateChange& change, double fraction_of_rest) {
    for (LoneBubble& bubble : foam.lone_bubbles) {
        if (const DrivenBubble* driven = find_driven(change, bubble.identity)) {
            bubble.target_area += fraction_of_rest * (driven->target_area - bubble.target_area);
        }
    }
}

// Scales the target areas of a torus so that their sum is the area of the torus. Driven bubbles
// keep their target areas, unless they would take more than kMaxDrivenFraction of the torus;
// the other bubbles fill the rest. If there are no other bubbles, the driven bubbles fill the
// torus. Does nothing if no bubble is driven.
void scale_targets_to_torus(Foam& foam, const Indexed<BubbleId, char>& is_driven) {
    double driven = 0.0;
    double others = 0.0;
    for (const BubbleId bubble : foam.network.bubbles()) {
        (is_driven[bubble] != 0 ? driven : others) += foam.target_areas[bubble];
    }
    if (driven == 0.0) {
        return;
    }
    const double area = foam.domain.area();
    const double to_driven = others == 0.0 ? area : std::min(driven, kMaxDrivenFraction * area);
    for (const BubbleId bubble : foam.network.bubbles()) {
        foam.target_areas[bubble] *=
            is_driven[bubble] != 0 ? to_driven / driven : (area - to_driven) / others;
    }
}

}  // namespace

DrivenBubble forced_collapse(BubbleIdentity bubble, const TopologyThresholds& thresholds) {
    return {bubble, thresholds.t2_area, true};
}

void drive(Foam& foam, const StateChange& change, double fraction_of_rest) {
    Indexed<BubbleId, char> is_driven(foam.network.bubble_slots(), 0);
    for (const LiveDrivenBubble& live : live_driven_bubbles(foam, change)) {
        double& target = foam.target_areas[live.bubble];
        target += fraction_of_rest * (live.driven.target_area - target);
        is_driven[live.bubble] = 1;
    }
    if (foam.domain.is_plane()) {
        drive_lone(foam, change, fraction_of_rest);
    } else {
        scale_targets_to_torus(foam, is_driven);
    }
}

double max_fraction_of_change(const Foam& foam,
                              const StateChange& change,
                              double largest_loss,
                              double vanishing_area) {
    double fraction = 1.0;
    for (const LiveDrivenBubble& live : live_driven_bubbles(foam, change)) {
        const double area = foam.target_areas[live.bubble];
        const double gain = live.driven.target_area - area;
        if (gain > 0.0) {
            fraction = std::min(fraction, kMaxGain * area / gain);
        } else if (gain < 0.0 && area > vanishing_area) {
            fraction = std::min(fraction, largest_loss * area / -gain);
        }
    }
    return fraction;
}

TopologyCounts collapse_forced(Foam& foam, const StateChange& change) {
    TopologyCounts counts;
    for (const LiveDrivenBubble& live : live_driven_bubbles(foam, change)) {
        // If both bubbles of a raft of two are to vanish, the removal of the first makes the second
        // a lone bubble, which collapse_lone removes below.
        if (live.driven.vanishes && foam.network.is_live(live.bubble)) {
            collapse(foam, live.bubble, counts);
        }
    }
    counts.t2 += collapse_lone(foam, [&](const LoneBubble& bubble) {
        const DrivenBubble* driven = find_driven(change, bubble.identity);
        return driven != nullptr && driven->vanishes;
    });
    return counts;
}

}  // namespace foam
