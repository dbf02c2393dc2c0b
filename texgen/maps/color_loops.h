// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/parallel/simd_level.h"
#include "texgen/image/color.h"
#include "texgen/image/image.h"
#include "texgen/maps/map_image.h"
#include "texgen/raster/simd/kernel.h"

#include <array>
#include <cassert>
#include <cstddef>
#include <cstdint>

namespace foam::texgen {

namespace detail {

// Replaces the colors of `count` pixels, each of `Channels` samples, as change_colors describes.
template <int Channels, class Kernel>
void change_all_colors(std::uint16_t* samples, std::size_t count, const Kernel& kernel) {
    at_simd_level([=] {
        constexpr auto kMaxSample = static_cast<float>(kWhite);
        for (std::size_t k = 0; k < count; ++k) {
            std::uint16_t* const pixel = samples + Channels * k;
            const std::array<float, 3> color = kernel({static_cast<float>(pixel[0]),
                                                       static_cast<float>(pixel[1]),
                                                       static_cast<float>(pixel[2])},
                                                      k);
            for (std::size_t c = 0; c < 3; ++c) {
                const float inside = min_value(max_value(color[c], 0.0F), kMaxSample);
                const float raised = inside + 0.5F;  // std::lround would not be vectorized
                pixel[c] = static_cast<std::uint16_t>(static_cast<int>(raised));
            }
        }
    });
}

}  // namespace detail

/// Replaces the color of each pixel by kernel(color, index), clamped to [0, kWhite] and rounded. A
/// color is an array of red, green and blue samples (ColorPixels). `index` counts pixels row by row
/// from the bottom row. The calls are made in a vectorized loop (at_simd_level), so the kernel has
/// to capture by value, and all functions that it calls have to be inline. Opacities do not change.
/// Precondition: the image has three or four channels.
template <class Kernel>
void change_colors(Image<std::uint16_t>& image, const Kernel& kernel) {
    assert(image.channels() == 3 || image.channels() == kChannelsWithOpacity);
    const auto count =
        static_cast<std::size_t>(image.width()) * static_cast<std::size_t>(image.height());
    if (image.channels() == 3) {
        detail::change_all_colors<3>(image.samples().data(), count, kernel);
    } else {
        detail::change_all_colors<kChannelsWithOpacity>(image.samples().data(), count, kernel);
    }
}

/// Mixes a color into each pixel of an image of three or four channels. A weight of 0 leaves a
/// pixel as it is, and a weight of 1 replaces its color. `weights` has one channel.
inline void mix_in(const LinearRgb& color,
                   const Image<float>& weights,
                   Image<std::uint16_t>& image) {
    const std::array<float, 3> added = {static_cast<float>(kWhite * color.r),
                                        static_cast<float>(kWhite * color.g),
                                        static_cast<float>(kWhite * color.b)};
    change_colors(
        image,
        [added, parts = weights.samples().data()](const std::array<float, 3>& old, std::size_t k) {
            const float part = parts[k];
            return std::array{old[0] + (added[0] - old[0]) * part,
                              old[1] + (added[1] - old[1]) * part,
                              old[2] + (added[2] - old[2]) * part};
        });
}

}  // namespace foam::texgen
