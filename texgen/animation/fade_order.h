// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/foam/frame.h"
#include "texgen/animation/periodic_waves.h"

#include <cstdint>
#include <vector>

namespace foam::texgen {

/// The order in which the bubbles of a foam appear in the cross-fade of a flow (LOOPS.md).
/// Neighbors appear at about the same time, and bubbles that are several bubbles apart appear at
/// different times. At any moment, the bubbles that have appeared therefore form large regions,
/// which grow.
class FadeOrder {
  public:
    struct Options {
        double bubbles = 1.0;  // approximate number of bubbles of the foam
        double spread = 0.0;   // fraction of the cross-fade after which the last bubble begins to
                               // appear, below 1; with 0, all bubbles appear at the same time
        double aspect = 1.0;   // width of the torus divided by its height
        std::uint64_t seed = 1;
    };

    explicit FadeOrder(const Options& options);

    /// Returns the rank of every bubble of a frame, in the order of Frame::bubbles. Ranks are from
    /// 0, for bubbles that appear first, to 1, for bubbles that appear last. The rank of a bubble
    /// depends on the mean position of its junctions minus `displacement`. If `displacement` is the
    /// displacement of the foam by a drift, a bubble keeps its rank while it drifts. Precondition:
    /// the frame is on a torus.
    std::vector<double> ranks(const Frame& frame, const Vec2& displacement) const;

    /// Returns how far a bubble with the given rank has grown, from 0 to 1. `passed` is the elapsed
    /// fraction of the cross-fade, from 0 to 1. The result is 0 at the start of the cross-fade and
    /// 1 at its end.
    double growth(double rank, double passed) const;

  private:
    double spread_;
    std::vector<PeriodicWave> waves_;
};

}  // namespace foam::texgen
