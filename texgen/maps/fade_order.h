#pragma once

#include "texgen/image/image.h"

#include <cstdint>

namespace foam::texgen {

/// The order in which the pixels of a tile fade: neighbors at about the same time, points some
/// bubbles apart at other times. Only a part of the image is between two foams at any moment.
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

    /// Returns the share of the rising image in every pixel, from 0 to 1, when a fraction of the
    /// fade has passed, from 0 to 1: all 0 at its start, all 1 at its end, and level at both.
    Image<float> shares(double passed) const;

  private:
    double spread_;
    Image<float> turns_;  // from 0, the first places, to 1, the last
};

}  // namespace foam::texgen
