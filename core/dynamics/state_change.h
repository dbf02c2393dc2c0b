// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/dynamics/collapse.h"
#include "core/dynamics/displacement.h"
#include "core/foam/foam.h"

#include <vector>

namespace foam {

/// A bubble whose target area is imposed from outside.
struct DrivenBubble {
    BubbleIdentity bubble = 0;
    double target_area = 0.0;  // at the end of the change, in foam units; positive
    bool vanishes = false;     // removed at the end of the change, with any number of sides
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

/// Changes the target area of every driven bubble by a part, at most 1, of its difference from the
/// final area. On a torus the total is unchanged: the gas comes from and goes to all other bubbles
/// in proportion to their target areas. If the driven bubbles would fill more than nine tenths of
/// the torus, their target areas are scaled down to nine tenths. If every bubble is driven, their
/// target areas are scaled to fill the torus. In a patch the gas comes from and goes to the
/// atmosphere, and the other bubbles keep their target areas.
void drive(Foam& foam, const StateChange& change, double part);

/// Returns the largest part, at most 1, of the remaining change of areas that may be imposed at
/// once. A driven bubble may lose at most the fraction `largest_loss` of its area, unless its area
/// is at most `vanishing_area`, and may gain at most three times its area.
double safe_part(const Foam& foam,
                 const StateChange& change,
                 double largest_loss,
                 double vanishing_area);

/// Removes the driven bubbles that are to vanish, by T1s and T2 (E8). A bubble that cannot vanish,
/// for example the last one of a torus, is kept. Lone bubbles vanish directly.
TopologyCounts collapse_forced(Foam& foam, const StateChange& change);

}  // namespace foam
