// SPDX-License-Identifier: Apache-2.0

#include "texgen/maps/number_extent.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numeric>
#include <vector>

namespace foam::texgen {

NumberExtent extent_of(const NumberPixels& numbers) {
    std::vector<std::size_t> channels(static_cast<std::size_t>(numbers.pixels.channels()));
    std::iota(channels.begin(), channels.end(), std::size_t{0});
    return extent_of(numbers, channels);
}

NumberExtent extent_of(const NumberPixels& numbers, std::span<const std::size_t> channels) {
    const double margin = 0.5 * (numbers.high - numbers.low) / 65535.0;
    const auto low = static_cast<float>(numbers.low - margin);
    const auto high = static_cast<float>(numbers.high + margin);
    const std::span<const float> samples = numbers.pixels.samples();
    const auto stride = static_cast<std::size_t>(numbers.pixels.channels());
    float smallest = std::numeric_limits<float>::infinity();
    float largest = -smallest;
    std::size_t clipped = 0;
    for (const std::size_t channel : channels) {
        for (std::size_t k = channel; k < samples.size(); k += stride) {
            if (std::isfinite(samples[k])) {
                smallest = std::min(smallest, samples[k]);
                largest = std::max(largest, samples[k]);
                clipped += samples[k] < low || samples[k] > high ? 1U : 0U;
            }
        }
    }
    if (smallest > largest) {
        return {};
    }
    const std::size_t count = samples.size() / stride * channels.size();
    return {static_cast<double>(smallest),
            static_cast<double>(largest),
            static_cast<double>(clipped) / static_cast<double>(count)};
}

NumberExtent joined(const NumberExtent& one, const NumberExtent& other) {
    return {std::min(one.smallest, other.smallest),
            std::max(one.largest, other.largest),
            std::max(one.clipped, other.clipped)};
}

}  // namespace foam::texgen
