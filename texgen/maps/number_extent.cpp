// SPDX-License-Identifier: Apache-2.0

#include "texgen/maps/number_extent.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

namespace foam::texgen {

NumberExtent extent_of(const NumberPixels& numbers) {
    const double margin = 0.5 * (numbers.high - numbers.low) / 65535.0;
    const auto low = static_cast<float>(numbers.low - margin);
    const auto high = static_cast<float>(numbers.high + margin);
    float smallest = std::numeric_limits<float>::infinity();
    float largest = -smallest;
    std::size_t clipped = 0;
    for (const float number : numbers.pixels.samples()) {
        if (std::isfinite(number)) {
            smallest = std::min(smallest, number);
            largest = std::max(largest, number);
            clipped += number < low || number > high ? 1 : 0;
        }
    }
    if (smallest > largest) {
        return {};
    }
    return {static_cast<double>(smallest),
            static_cast<double>(largest),
            static_cast<double>(clipped) / static_cast<double>(numbers.pixels.samples().size())};
}

NumberExtent joined(const NumberExtent& one, const NumberExtent& other) {
    return {std::min(one.smallest, other.smallest),
            std::max(one.largest, other.largest),
            std::max(one.clipped, other.clipped)};
}

}  // namespace foam::texgen
