#pragma once

#include "core/equilibrium/unknowns.h"

#include <Eigen/Core>

#include <vector>

namespace foam {

struct SpotOptions {
    double force = 0.1;          // on a junction, in film tensions, above which it is a bad one
    double area = 0.3;           // relative area error above which a bubble is a bad one
    int rings = 1;               // of neighbours around what is bad
    double largest_share = 0.3;  // of all bubbles: where more are in spots, there are none
};

/// A few bubbles, in increasing order, in whose midst the foam is far from equilibrium.
using Spot = std::vector<BubbleId>;

/// The separate spots to which what is far from equilibrium is confined, in the order of their
/// first bubbles. Empty where nothing is, or too much. The residual is that of all unknowns.
std::vector<Spot> find_spots(const Foam& foam,
                             const Unknowns& unknowns,
                             const Eigen::VectorXd& residual,
                             const SpotOptions& options);

}  // namespace foam
