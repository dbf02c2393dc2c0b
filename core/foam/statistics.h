// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/foam/frame.h"

#include <vector>

namespace foam {

/// Statistics of the bubbles with a given number of sides. Outer films count as sides; lone bubbles
/// have 0 sides.
struct SidesStatistics {
    int sides = 0;
    int bubbles = 0;
    double mean_area = 0.0;      // of the areas bounded by the arcs, not by their chords
    double mean_pressure = 0.0;  // on a torus determined only up to a common constant
    // The mean rate at which gas enters a bubble through its films, divided by the diffusion
    // constant kappa (E6 in core/EQUATIONS.md). The rate of one bubble is the sum over its films of
    // (outside pressure - own pressure) times length. In equilibrium, von Neumann's law (E6) gives
    // (2 pi / 3) gamma (n - 6) for n sides, where gamma is half of the film tension.
    double mean_inflow = 0.0;
};

/// Statistics of a foam. All values are 0 if no bubble is left, for example after the last bubble
/// of a patch has vanished.
struct FoamStatistics {
    int bubbles = 0;
    double mean_area = 0.0;
    double energy = 0.0;         // film tension times the length of all films and of the circles
                                 // of lone bubbles
    double mean_sides = 0.0;     // 6 on a torus (Euler), usually fewer in a patch
    double second_moment = 0.0;  // mu_2, the variance of the number of sides over all bubbles
    // One entry for each number of sides that occurs, in increasing order.
    std::vector<SidesStatistics> by_sides;
};

/// Returns the statistics of a frame.
FoamStatistics statistics(const Frame& frame);

/// Returns the mean area of all bubbles, including lone bubbles. Returns 0 for a patch without
/// bubbles.
double mean_area(const Frame& frame);

/// Mean growth rate of the bubbles with a given number of sides, measured from their areas.
struct SidesGrowth {
    int sides = 0;
    int bubbles = 0;
    double mean_rate = 0.0;  // change of the area divided by the elapsed foam time
};

/// Returns the growth rates between two instants of one foam, by increasing number of sides. Only
/// bubbles with the same neighbors at both instants count, to leave out bubbles that took part in a
/// topology change. A bubble that lost a neighbor between the instants and got the same neighbor
/// back still counts. Lone bubbles do not count. Returns an empty list if no time has passed.
std::vector<SidesGrowth> growth_by_sides(const Frame& before, const Frame& after);

}  // namespace foam
