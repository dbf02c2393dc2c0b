// SPDX-License-Identifier: Apache-2.0

#include "texgen/maps/cross_fade.h"

#include "texgen/image/bleed.h"

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

void mix(std::span<std::uint16_t> fading_out,
         std::span<const std::uint16_t> fading_in,
         float weight) {
    constexpr std::uint32_t kWhole = 1U << 16U;
    constexpr std::uint32_t kHalf = kWhole / 2;
    const auto weight_in = static_cast<std::uint32_t>(std::lround(weight * kWhole));
    for (std::size_t c = 0; c < fading_out.size(); ++c) {
        // The weights add up to 2^16 and both samples are below 2^16, so the sum fits into 32 bits.
        fading_out[c] = static_cast<std::uint16_t>(
            ((kWhole - weight_in) * fading_out[c] + weight_in * fading_in[c] + kHalf) >> 16U);
    }
}

void mix(std::span<float> fading_out, std::span<const float> fading_in, float weight) {
    for (std::size_t c = 0; c < fading_out.size(); ++c) {
        fading_out[c] += weight * (fading_in[c] - fading_out[c]);
    }
}

void mix(std::span<std::uint32_t> fading_out,
         std::span<const std::uint32_t> fading_in,
         float weight) {
    if (weight >= 0.5F) {
        fading_out[0] = fading_in[0];
    }
}

// Interpolates the slopes -x / z and -y / z of two normals. Replaces `fading_out` by the unit
// normal with the resulting slopes. Multiplying the interpolated vector by both values of z avoids
// divisions.
void mix_slopes(std::span<float> fading_out, std::span<const float> fading_in, float weight) {
    const float weight_out = (1.0F - weight) * fading_in[2];
    const float weight_in = weight * fading_out[2];
    const float x = weight_out * fading_out[0] + weight_in * fading_in[0];
    const float y = weight_out * fading_out[1] + weight_in * fading_in[1];
    const float z = fading_in[2] * fading_out[2];
    const float length = std::sqrt(x * x + y * y + z * z);
    fading_out[0] = x / length;
    fading_out[1] = y / length;
    fading_out[2] = z / length;
}

// Stores the mixture of two images in `fading_out`. `weights` are the weights of `fading_in`. Calls
// mix_pixel for pixels in which both images have a weight above 0. Each other pixel gets the
// unchanged samples of the image whose weight is 1.
template <class Sample, class Mix>
void mix_pixels(Image<Sample>& fading_out,
                const Image<Sample>& fading_in,
                const Image<float>& weights,
                const Mix& mix_pixel) {
    const auto channels = static_cast<std::size_t>(fading_out.channels());
    for (std::size_t k = 0; k < weights.samples().size(); ++k) {
        const float weight = weights.samples()[k];
        const auto to = fading_out.samples().subspan(k * channels, channels);
        const auto from = fading_in.samples().subspan(k * channels, channels);
        if (weight == 1.0F) {
            std::copy(from.begin(), from.end(), to.begin());
        } else if (weight > 0.0F) {
            mix_pixel(to, from, weight);
        }
    }
}

template <class Sample>
void fade(Image<Sample>& fading_out,
          const Image<Sample>& fading_in,
          const Image<float>& weights,
          Mixing /*mixing*/) {
    mix_pixels(fading_out, fading_in, weights, [](auto to, auto from, float weight) {
        mix(to, from, weight);
    });
}

void fade(Image<float>& fading_out,
          const Image<float>& fading_in,
          const Image<float>& weights,
          Mixing mixing) {
    const bool are_slopes = mixing == Mixing::Slopes;
    mix_pixels(fading_out, fading_in, weights, [&](auto to, auto from, float weight) {
        are_slopes ? mix_slopes(to, from, weight) : mix(to, from, weight);
    });
}

// Draws a map of one foam, and gives colors to the pixels without opacity.
MapImage draw_and_bleed(const Map& map, FrameLayers& layers, const MapOptions& options) {
    MapImage image = map.draw(layers, options);
    auto* const colors = std::get_if<ColorPixels>(&image);
    if (colors != nullptr && colors->pixels.channels() == kChannelsWithOpacity) {
        bleed_colors(colors->pixels.view(), colors->fallback);
    }
    return image;
}

}  // namespace

MapImage draw(const Map& map, ShownLayers& content, const MapOptions& options) {
    MapImage image = draw_and_bleed(map, content.layers, options);
    if (!content.fading_in) {
        return image;
    }
    return cross_fade(std::move(image),
                      draw_and_bleed(map, *content.fading_in, options),
                      content.layers.border()->weights,
                      map.mixing);
}

MapImage cross_fade(MapImage fading_out,
                    const MapImage& fading_in,
                    const Image<float>& weights,
                    Mixing mixing) {
    std::visit(
        [&](auto& image) {
            const auto& other = std::get<std::remove_reference_t<decltype(image)>>(fading_in);
            fade(image.pixels, other.pixels, weights, mixing);
        },
        fading_out);
    return fading_out;
}

}  // namespace foam::texgen
