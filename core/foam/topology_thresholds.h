// SPDX-License-Identifier: Apache-2.0

#pragma once

namespace foam {

/// Thresholds at which the topology changes (paper eq. 2, 3 and 16), in foam units.
struct TopologyThresholds {
    double t1_distance = 0.05;  // a film with a shorter chord may flip (E7)
    double t2_area = 0.01;      // a three-sided bubble with at most this area vanishes (E8)
};

}  // namespace foam
