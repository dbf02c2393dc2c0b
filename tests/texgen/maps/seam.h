// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/image/image.h"
#include "texgen/verify/steps.h"

#include <algorithm>
#include <array>

namespace foam::texgen::test {

/// Returns the seam ratio of a tile, as `verify` measures it: the mean step from the last column to
/// the first one, divided by the largest mean step between two adjacent columns. The same is
/// computed for the rows, and the larger ratio is returned. The ratio of a tile without a seam is
/// at most kMaxTileRatio.
///
/// Before that, adds a ramp from 0 at the left border to `ramp` at the right border, which makes a
/// seam of this height.
template <class Sample>
double seam_ratio(const Image<Sample>& image, double ramp = 0.0) {
    Image<float> numbers(image.width(), image.height(), image.channels());
    for (int y = 0; y < image.height(); ++y) {
        for (int x = 0; x < image.width(); ++x) {
            const double added = ramp * x / (image.width() - 1);
            std::ranges::transform(
                image.pixel(x, y), numbers.pixel(x, y).begin(), [&](Sample sample) {
                    return static_cast<float>(static_cast<double>(sample) + added);
                });
        }
    }
    const ChannelGroup group{{}, SampleType::Float, std::move(numbers)};
    const std::array<const ChannelGroup*, 1> groups{&group};
    const TileSeams seams = tile_seams(groups, Difference::Numbers);
    return std::max(seams.columns.ratio(), seams.rows.ratio());
}

}  // namespace foam::texgen::test
