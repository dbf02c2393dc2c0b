#pragma once

#include <vector>

namespace foam::texgen {

/// What the maps of a frame need to know of the frames before it; the same whichever of them are
/// drawn.
struct FoamRecord {
    /// The pressures of all bubbles in the first equilibrium that a frame shows, over the film
    /// tension and times the root of the mean area, in increasing order. They scale the pressures
    /// of all frames, so that none flickers.
    std::vector<double> first_pressures{};
};

}  // namespace foam::texgen
