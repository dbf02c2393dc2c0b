// SPDX-License-Identifier: Apache-2.0

#pragma once

namespace foam {

/// Thresholds at which the topology changes (E7 and E8 in core/EQUATIONS.md; paper
/// eq. 2, 3 and 16), in foam units.
struct TopologyThresholds {
    double t1_distance = 0.05;  // a film with a shorter chord may flip (E7)
    // Bubbles of two or three sides, and lone bubbles, vanish at or below this target area (E8).
    double t2_area = 0.01;
};

}  // namespace foam
