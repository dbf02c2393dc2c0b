#pragma once

#include "texgen/image/image.h"

#include <cstdint>

namespace foam::texgen {

/// When the places of a tile fade in a cross-fade: those beside each other at about the same time,
/// those some bubbles apart at others. So only a part of the foam is between two at any moment.
class FadeOrder {
  public:
    struct Options {
        int width = 1;  // of the tile, pixels
        int height = 1;
        double bubbles = 1.0;  // in it, about
        double spread = 0.0;   // 0: all places at once, towards 1: each in a moment of its own
        std::uint64_t seed = 1;
    };

    explicit FadeOrder(const Options& options);

    /// What every pixel shows of what rises, from 0 to 1, when this part of the fade has passed,
    /// from 0 to 1: all 0 at its start, all 1 at its end, and level at both.
    Image<float> shares(double passed) const;

  private:
    double spread_;
    Image<float> turns_;  // from 0, the first places, to 1, the last
};

}  // namespace foam::texgen
