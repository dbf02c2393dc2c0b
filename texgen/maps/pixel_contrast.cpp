// SPDX-License-Identifier: Apache-2.0

#include "texgen/maps/pixel_contrast.h"

#include "texgen/maps/map_image.h"

#include <cmath>
#include <cstddef>

namespace foam::texgen {

std::vector<std::uint32_t> find_contrasts(std::span<const float> brightness,
                                          std::span<const float> distances,
                                          const PixelNeighbors& neighbors) {
    constexpr float kContrast = 0.025F;                         // smallest relative difference
    constexpr float kDark = 0.1F * static_cast<float>(kWhite);  // reduces differences in the dark
    constexpr float kNear = 1.0F;                               // pixels
    const auto bends = [&](std::size_t k, std::size_t before, std::size_t after) {
        const float bend = 0.5F * (brightness[before] + brightness[after]) - brightness[k];
        return std::abs(bend) > kContrast * (brightness[k] + kDark);
    };
    std::vector<std::uint32_t> pixels;
    for (std::size_t k = 0; k < brightness.size(); ++k) {
        if (distances[k] < kNear || bends(k, neighbors.left(k), neighbors.right(k)) ||
            bends(k, neighbors.below(k), neighbors.above(k))) {
            pixels.push_back(static_cast<std::uint32_t>(k));
        }
    }
    return pixels;
}

}  // namespace foam::texgen
