#pragma once

#include "core/foam/frame.h"

#include <vector>

namespace foam {

/// The bubbles of one number of sides, outer films among them; lone bubbles have none.
struct SidesStatistics {
    int sides = 0;
    int bubbles = 0;
    double mean_area = 0.0;      // within the arcs
    double mean_pressure = 0.0;  // with the foam's constant, which an equilibrium sets (measure.h)
    // What comes in through the films of a bubble, over kappa: the pressure difference times the
    // length of every film. In equilibrium von Neumann's law holds: (2 pi / 3) gamma (n - 6) (E6).
    double mean_inflow = 0.0;
};

/// A foam in numbers: all 0 where no bubble is left, as of a patch at its end.
struct FoamStatistics {
    int bubbles = 0;
    double mean_area = 0.0;
    double energy = 0.0;         // film tension times the length of all films
    double mean_sides = 0.0;     // 6 on a torus (Euler), fewer in a patch
    double second_moment = 0.0;  // mu_2 = sum of p(n) (n - mean)^2, p(n) the share of the n-sided
    std::vector<SidesStatistics> by_sides;  // in increasing order, those that occur
};

FoamStatistics statistics(const Frame& frame);

/// Of all bubbles, lone ones too; 0 where the last is gone.
double mean_area(const Frame& frame);

/// How fast the bubbles of one number of sides grew, as their areas tell.
struct SidesGrowth {
    int sides = 0;
    int bubbles = 0;
    double mean_rate = 0.0;  // change of the area over the time
};

/// The growth between two instants of one foam of the bubbles that no event touched, which is to
/// say that they have the same neighbours at both: one that lost a neighbour and got it back in
/// between is not told from them. In increasing order of sides; empty if no time has passed.
std::vector<SidesGrowth> growth_by_sides(const Frame& before, const Frame& after);

}  // namespace foam
