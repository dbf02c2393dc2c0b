// SPDX-License-Identifier: Apache-2.0

#include "texgen/maps/cross_fade.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <type_traits>
#include <utility>
#include <variant>

namespace foam::texgen {

namespace {

void mix(std::span<std::uint16_t> falling, std::span<const std::uint16_t> rising, float share) {
    constexpr std::uint32_t kWhole = 1U << 16U;
    constexpr std::uint32_t kHalf = kWhole / 2;
    const auto risen = static_cast<std::uint32_t>(std::lround(share * kWhole));
    for (std::size_t c = 0; c < falling.size(); ++c) {
        // The weights add up to 2^16 and both numbers are below 2^16, so 32 bits hold the sum.
        falling[c] = static_cast<std::uint16_t>(
            ((kWhole - risen) * falling[c] + risen * rising[c] + kHalf) >> 16U);
    }
}

void mix(std::span<float> falling, std::span<const float> rising, float share) {
    for (std::size_t c = 0; c < falling.size(); ++c) {
        falling[c] += share * (rising[c] - falling[c]);
    }
}

void mix(std::span<std::uint32_t> falling, std::span<const std::uint32_t> rising, float share) {
    if (share >= 0.5F) {
        falling[0] = rising[0];
    }
}

// Mixes two normals by their slopes -x / z and -y / z, and normalizes the result. Both slopes are
// multiplied by both z, which avoids a division.
void mix_slopes(std::span<float> falling, std::span<const float> rising, float share) {
    const float fallen = (1.0F - share) * rising[2];
    const float risen = share * falling[2];
    const float x = fallen * falling[0] + risen * rising[0];
    const float y = fallen * falling[1] + risen * rising[1];
    const float z = rising[2] * falling[2];
    const float length = std::sqrt(x * x + y * y + z * z);
    falling[0] = x / length;
    falling[1] = y / length;
    falling[2] = z / length;
}

// Calls mix_pixel for pixels that show both images. Pixels that show only one keep its samples to
// the bit.
template <class Sample, class Mix>
void mix_pixels(Image<Sample>& falling,
                const Image<Sample>& rising,
                const Image<float>& shares,
                const Mix& mix_pixel) {
    const auto channels = static_cast<std::size_t>(falling.channels());
    for (std::size_t k = 0; k < shares.samples().size(); ++k) {
        const float share = shares.samples()[k];
        const auto to = falling.samples().subspan(k * channels, channels);
        const auto from = rising.samples().subspan(k * channels, channels);
        if (share == 1.0F) {
            std::copy(from.begin(), from.end(), to.begin());
        } else if (share > 0.0F) {
            mix_pixel(to, from, share);
        }
    }
}

template <class Sample>
void fade(Image<Sample>& falling,
          const Image<Sample>& rising,
          const Image<float>& shares,
          Mixing /*mixing*/) {
    mix_pixels(
        falling, rising, shares, [](auto to, auto from, float share) { mix(to, from, share); });
}

void fade(Image<float>& falling,
          const Image<float>& rising,
          const Image<float>& shares,
          Mixing mixing) {
    const bool are_slopes = mixing == Mixing::Slopes;
    mix_pixels(falling, rising, shares, [&](auto to, auto from, float share) {
        are_slopes ? mix_slopes(to, from, share) : mix(to, from, share);
    });
}

}  // namespace

MapImage draw(const Map& map, ShownLayers& shown, const MapOptions& options) {
    MapImage image = map.draw(shown.layers, options);
    if (!shown.rising) {
        return image;
    }
    return cross_fade(std::move(image), map.draw(*shown.rising, options), shown.shares, map.mixing);
}

MapImage cross_fade(MapImage falling,
                    const MapImage& rising,
                    const Image<float>& shares,
                    Mixing mixing) {
    std::visit(
        [&](auto& image) {
            const auto& other = std::get<std::remove_reference_t<decltype(image)>>(rising);
            fade(image.pixels, other.pixels, shares, mixing);
        },
        falling);
    return falling;
}

}  // namespace foam::texgen
