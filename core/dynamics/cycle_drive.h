// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/dynamics/boiling.h"
#include "core/foam/foam.h"

#include <cstdint>
#include <vector>

namespace foam {

/// A periodic change of a foam (E9).
struct CycleOptions {
    int steps = 48;               // number of steps of one cycle; at least 10 if bubbles boil
    double area_amplitude = 0.0;  // relative amplitude of target areas, with random phases
    double strain = 0.0;          // amplitude of the shear strain of a torus
    double boiling = 0.0;         // fraction of the bubbles that vanish and are born again
    // The largest rise of the target area of a boiling bubble at first (P in E9). The unit is the
    // target area that the bubble had before the boil.
    double boiling_rise = 2.5;
    std::uint64_t seed = 1;  // seed of the random phases and of the choice of bubbles
};

/// A bubble whose target area oscillates. At the time t, in cycles, the target area is
/// mean_area * (1 + amplitude * sin 2 pi (t + phase)).
struct OscillatingBubble {
    BubbleIdentity bubble = 0;
    double mean_area = 0.0;
    double amplitude = 0.0;  // relative to mean_area
    double phase = 0.0;      // in turns
};

/// The drive of a Cycle determines how each bubble of a foam changes: some boil, all others
/// oscillate.
struct CycleDrive {
    std::vector<BoilingBubble> boiling;
    std::vector<OscillatingBubble> oscillating;
};

/// Chooses the bubbles that boil and the phases of all others at random. The mean areas are the
/// present target areas of the foam.
CycleDrive random_drive(const Foam& foam, const CycleOptions& options);

}  // namespace foam
