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
    bool vanishes = false;     // true if the bubble is removed at the end of the change
};

/// A change that is imposed on a foam from outside during a step (paper eq. 9). Entries of bubbles
/// that have vanished are ignored.
struct StateChange {
    std::vector<DrivenBubble> driven{};
    double strain = 0.0;  // every point of a torus moves to the right by strain * y (shear.h)
    std::vector<Displacement> pushes{};

    bool empty() const { return driven.empty() && strain == 0.0 && pushes.empty(); }
};

/// Returns the entry of StateChange::driven that makes a bubble collapse on command (paper Figure
/// 7). The bubble shrinks to the T2 area and loses sides by T1s meanwhile. At the end it vanishes,
/// whatever its number of sides.
DrivenBubble forced_collapse(BubbleIdentity bubble, const TopologyThresholds& thresholds);

/// Moves the target area of every driven bubble toward its final value (DrivenBubble::target_area)
/// by the fraction `fraction_of_rest`, at most 1, of the difference. On a torus the sum of the
/// target areas is unchanged: the gas comes from and goes to all other bubbles in proportion to
/// their target areas. If the driven bubbles would fill more than nine tenths of the torus, their
/// target areas are scaled down so that they fill nine tenths. If every bubble is driven, all
/// target areas are scaled to fill the torus. In a patch the gas comes from and goes to the ghost,
/// and the other bubbles keep their target areas.
void drive(Foam& foam, const StateChange& change, double fraction_of_rest);

/// Returns the largest fraction, at most 1, of the remaining change of target areas that may be
/// imposed at once. A driven bubble may gain at most three times its target area. It may lose at
/// most the fraction `largest_loss` of its target area, or all of its target area if this area is
/// at most `vanishing_area`. Lone bubbles set no limit.
double max_fraction_of_change(const Foam& foam,
                              const StateChange& change,
                              double largest_loss,
                              double vanishing_area);

/// Removes the driven bubbles that are to vanish, by T1s and T2 (E8). A bubble that cannot vanish,
/// for example the last one of a torus, is kept. Lone bubbles vanish directly. Returns the numbers
/// of T1s and T2s.
TopologyCounts collapse_forced(Foam& foam, const StateChange& change);

}  // namespace foam
