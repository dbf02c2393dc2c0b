#pragma once

#include "core/dynamics/collapse.h"
#include "core/dynamics/displacement.h"
#include "core/foam/foam.h"

#include <vector>

namespace foam {

/// A bubble whose target area is imposed from outside.
struct DrivenBubble {
    BubbleIdentity bubble = 0;
    double target_area = 0.0;  // at the end of the change; positive, foam units
    bool vanishes = false;     // at the end, whatever its number of sides
};

/// A change that is imposed on a foam from outside during a step (paper eq. 9). Bubbles that have
/// vanished are ignored.
struct StateChange {
    std::vector<DrivenBubble> driven{};
    double strain = 0.0;  // simple shear along x (shear.h)
    std::vector<Displacement> pushes{};

    bool empty() const { return driven.empty() && strain == 0.0 && pushes.empty(); }
};

/// Returns the change that makes a bubble collapse on command (paper Figure 7): it shrinks to the
/// T2 area, loses sides by T1 meanwhile, and vanishes.
DrivenBubble forced_collapse(BubbleIdentity bubble, const TopologyThresholds& thresholds);

/// Moves the target area of every driven bubble by a part, at most 1, of its difference from the
/// final one. On a torus the total stays: the gas comes from and goes to all other bubbles in
/// proportion to their target areas. If driven bubbles would take more than nine tenths of the
/// torus, their targets are scaled down to nine tenths; if there are no others, to all of it. In a
/// patch the gas comes from and goes to the atmosphere, and the other bubbles keep theirs.
void drive(Foam& foam, const StateChange& change, double part);

/// Returns the largest part of the remaining change that may be imposed at once: a driven bubble
/// loses at most the share `largest_loss` of its area, unless that is below `vanishing_area`, and
/// gains at most three times its area.
double safe_part(const Foam& foam,
                 const StateChange& change,
                 double largest_loss,
                 double vanishing_area);

/// Makes the driven bubbles that are to vanish do so, by T1s and T2 (E8). A bubble that cannot, as
/// the last one of a torus, stays. Lone bubbles vanish directly.
TopologyCounts collapse_forced(Foam& foam, const StateChange& change);

}  // namespace foam
