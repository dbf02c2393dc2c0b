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

void mix(std::span<std::uint16_t> falling, std::span<const std::uint16_t> rising, float weight) {
    constexpr std::uint32_t kWhole = 1U << 16U;
    constexpr std::uint32_t kHalf = kWhole / 2;
    const auto risen = static_cast<std::uint32_t>(std::lround(weight * kWhole));
    for (std::size_t c = 0; c < falling.size(); ++c) {
        // The weights add up to 2^16 and both samples are below 2^16, so the sum fits into 32 bits.
        falling[c] = static_cast<std::uint16_t>(
            ((kWhole - risen) * falling[c] + risen * rising[c] + kHalf) >> 16U);
    }
}

void mix(std::span<float> falling, std::span<const float> rising, float weight) {
    for (std::size_t c = 0; c < falling.size(); ++c) {
        falling[c] += weight * (rising[c] - falling[c]);
    }
}

void mix(std::span<std::uint32_t> falling, std::span<const std::uint32_t> rising, float weight) {
    if (weight >= 0.5F) {
        falling[0] = rising[0];
    }
}

// Mixes two normals by their slopes -x / z and -y / z, and normalizes the result. The mixed slopes
// are multiplied by both values of z, which avoids a division.
void mix_slopes(std::span<float> falling, std::span<const float> rising, float weight) {
    const float fallen = (1.0F - weight) * rising[2];
    const float risen = weight * falling[2];
    const float x = fallen * falling[0] + risen * rising[0];
    const float y = fallen * falling[1] + risen * rising[1];
    const float z = rising[2] * falling[2];
    const float length = std::sqrt(x * x + y * y + z * z);
    falling[0] = x / length;
    falling[1] = y / length;
    falling[2] = z / length;
}

// Calls mix_pixel for pixels that show both images. Pixels that show only one image get exactly its
// samples.
template <class Sample, class Mix>
void mix_pixels(Image<Sample>& falling,
                const Image<Sample>& rising,
                const Image<float>& weights,
                const Mix& mix_pixel) {
    const auto channels = static_cast<std::size_t>(falling.channels());
    for (std::size_t k = 0; k < weights.samples().size(); ++k) {
        const float weight = weights.samples()[k];
        const auto to = falling.samples().subspan(k * channels, channels);
        const auto from = rising.samples().subspan(k * channels, channels);
        if (weight == 1.0F) {
            std::copy(from.begin(), from.end(), to.begin());
        } else if (weight > 0.0F) {
            mix_pixel(to, from, weight);
        }
    }
}

template <class Sample>
void fade(Image<Sample>& falling,
          const Image<Sample>& rising,
          const Image<float>& weights,
          Mixing /*mixing*/) {
    mix_pixels(
        falling, rising, weights, [](auto to, auto from, float weight) { mix(to, from, weight); });
}

void fade(Image<float>& falling,
          const Image<float>& rising,
          const Image<float>& weights,
          Mixing mixing) {
    const bool are_slopes = mixing == Mixing::Slopes;
    mix_pixels(falling, rising, weights, [&](auto to, auto from, float weight) {
        are_slopes ? mix_slopes(to, from, weight) : mix(to, from, weight);
    });
}

}  // namespace

MapImage draw(const Map& map, ShownLayers& shown, const MapOptions& options) {
    MapImage image = map.draw(shown.layers, options);
    if (!shown.rising) {
        return image;
    }
    return cross_fade(
        std::move(image), map.draw(*shown.rising, options), shown.weights, map.mixing);
}

MapImage cross_fade(MapImage falling,
                    const MapImage& rising,
                    const Image<float>& weights,
                    Mixing mixing) {
    std::visit(
        [&](auto& image) {
            const auto& other = std::get<std::remove_reference_t<decltype(image)>>(rising);
            fade(image.pixels, other.pixels, weights, mixing);
        },
        falling);
    return falling;
}

}  // namespace foam::texgen
