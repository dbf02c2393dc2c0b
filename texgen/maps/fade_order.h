// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/image/image.h"

#include <cstdint>

namespace foam::texgen {

/// The order in which the pixels of a tile, that is, of an image that tiles, fade from one image to
/// another. Neighboring pixels fade at about the same time, and pixels that are several bubbles
/// apart fade at different times, so that only a part of the tile shows a mixture of two foams at
/// any moment.
class FadeOrder {
  public:
    struct Options {
        int width = 1;  // width and height of the tile in pixels
        int height = 1;
        double bubbles = 1.0;    // approximate number of bubbles in the tile
        double spread = 0.0;     // fraction of the cross-fade after which the last pixel begins to
                                 // fade, below 1; with 0, all pixels fade at the same time
        std::uint64_t seed = 1;  // seed of the random order
    };

    explicit FadeOrder(const Options& options);

    /// Returns the weight of the image that fades in (cross_fade.h) in every pixel, from 0 to 1.
    /// `passed` is the elapsed fraction of the cross-fade, from 0 to 1. All weights are 0 at the
    /// start and 1 at the end of the cross-fade. The rate of change of each weight is 0 at the
    /// moments when its rise begins and ends.
    Image<float> weights(double passed) const;

  private:
    double spread_;
    Image<float> ranks_;  // the rank of each pixel: 0 fades first, 1 fades last
};

}  // namespace foam::texgen
