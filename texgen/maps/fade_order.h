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
        double spread = 0.0;  // 0 fades all pixels at the same time; larger values, below 1, spread
                              // the fades of the pixels over time
        std::uint64_t seed = 1;
    };

    explicit FadeOrder(const Options& options);

    /// Returns the weight of the rising image (cross_fade.h) in every pixel, from 0 to 1. `passed`
    /// is the elapsed fraction of the fade, from 0 to 1. All weights are 0 at the start and 1 at
    /// the end of the fade. Each weight has a slope of 0 in time where its rise begins and where it
    /// ends.
    Image<float> weights(double passed) const;

  private:
    double spread_;
    Image<float> turns_;  // the rank of each pixel: 0 fades first, 1 last
};

}  // namespace foam::texgen
