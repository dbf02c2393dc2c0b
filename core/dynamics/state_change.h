#pragma once

#include "core/dynamics/collapse.h"
#include "core/dynamics/displacement.h"
#include "core/foam/foam.h"

#include <vector>

namespace foam {

/// A bubble whose target area is given from outside instead of by diffusion.
struct DrivenBubble {
    BubbleIdentity bubble = 0;
    double target_area = 0.0;  // at the end of the change; positive, foam units
    bool vanishes = false;     // at the end, whatever its number of sides
};

/// What is imposed on a foam from outside in the course of a step (paper eq. 9). Bubbles that have
/// vanished are passed over.
struct StateChange {
    std::vector<DrivenBubble> driven{};
    double strain = 0.0;  // simple shear along x (shear.h)
    std::vector<Displacement> pushes{};

    bool empty() const { return driven.empty() && strain == 0.0 && pushes.empty(); }
};

/// The change that makes a bubble collapse on command (paper Figure 7): it shrinks to the T2 area,
/// losing sides by T1 on the way, and vanishes.
DrivenBubble forced_collapse(BubbleIdentity bubble, const TopologyThresholds& thresholds);

/// Brings every driven bubble by a part, at most 1, of the way from its present to its last target
/// area. The total stays: the gas comes from and goes to all other bubbles in proportion to their
/// target areas. Where driven bubbles would take more than nine tenths of the torus, their targets
/// are scaled down to these; where there are no others, to the whole of it. In a patch the gas
/// comes from and goes to the atmosphere, and others stay as they are.
void drive(Foam& foam, const StateChange& change, double part);

/// The largest part of what is left to drive that may be imposed at once: of a driven bubble's area
/// at most `largest_loss` is lost, where it is above `vanishing_area`, and at most threefold is
/// gained.
double safe_part(const Foam& foam,
                 const StateChange& change,
                 double largest_loss,
                 double vanishing_area);

/// The T2 of the driven bubbles that are to vanish, by way of T1 (E8). One that cannot, as the last
/// of a torus, stays. Lone bubbles vanish as they are.
TopologyCounts collapse_forced(Foam& foam, const StateChange& change);

}  // namespace foam
