// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/image/image.h"

#include <cstdint>

namespace foam::texgen {

/// The order in which the pixels of a tile fade. Neighboring pixels fade at about the same time,
/// and points several bubbles apart at different times, so that only a part of the image shows a
/// mixture of two foams at any moment.
class FadeOrder {
  public:
    struct Options {
        int width = 1;  // width and height of the tile in pixels
        int height = 1;
        double bubbles = 1.0;  // approximate number of bubbles in the tile
        double spread = 0.0;   // 0 fades all pixels at once, values towards 1 one after the other;
                               // below 1
        std::uint64_t seed = 1;
    };

    explicit FadeOrder(const Options& options);

    /// Returns the weight of the rising image in every pixel, from 0 to 1, after a fraction of the
    /// fade, from 0 to 1. All weights are 0 at the start and 1 at the end of the fade, and each has
    /// the slope 0 in time where it leaves 0 and reaches 1.
    Image<float> weights(double passed) const;

  private:
    double spread_;
    Image<float> turns_;  // the rank of each pixel: 0 fades first, 1 last
};

}  // namespace foam::texgen
