// SPDX-License-Identifier: Apache-2.0

#include "texgen/image/mip_chain.h"

#include "texgen/image/color.h"
#include "texgen/image/mip_level.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <iterator>
#include <limits>
#include <span>
#include <type_traits>
#include <utility>
#include <variant>

// Each level is computed from the level before it, and kept as planes: images of one channel. Ids
// are chosen among the ids of the level before, as integers. All other levels are computed in
// floating point. They are rounded to codes (integer samples) only to be stored, so rounding errors
// do not add up. Colors with an opacity have seven planes. Three contain the colors multiplied by
// the opacity, and one contains the opacity. The last three contain the colors alone, for pixels
// that become completely transparent.

namespace foam::texgen {

namespace {

using Planes = std::vector<Image<float>>;

constexpr std::size_t kColors = 3;   // red, green and blue
constexpr std::size_t kOpacity = 3;  // index of the opacity, both among channels and among planes

template <class Code>
constexpr float kMaxCode = static_cast<float>(std::numeric_limits<Code>::max());

// The conversion between codes and the numbers that are averaged.
template <class Code>
struct Conversion {
    TexelMeaning meaning;
    bool color;            // true if the codes are sRGB colors
    std::size_t channels;  // number of channels of the picture
    // The 8-bit sRGB code of each 16-bit value of linear light.
    std::span<const std::uint8_t, 65536> srgb_codes = srgb_codes_of_light();
    std::vector<float> light{};      // for colors: the linear light of each code
    std::vector<float> fractions{};  // for other channels: the number that each code represents

    Conversion(const Picture& picture, TexelMeaning given)
        : meaning(given),
          color(picture.metadata.color),
          channels(static_cast<std::size_t>(picture.groups.front().channels())) {
        for (int code = 0; code <= std::numeric_limits<Code>::max(); ++code) {
            const float fraction = static_cast<float>(code) / kMaxCode<Code>;
            fractions.push_back(meaning == TexelMeaning::Normals ? 2.0F * fraction - 1.0F
                                                                 : fraction);
            if (color) {
                light.push_back(static_cast<float>(
                    srgb_to_linear(code / static_cast<double>(std::numeric_limits<Code>::max()))));
            }
        }
    }

    bool has_opacity() const { return color && channels > kOpacity; }
    bool is_light(std::size_t channel) const { return color && channel < kColors; }

    // Returns the numbers that the codes of a channel represent. A code is the index of its number.
    std::span<const float> numbers(std::size_t channel) const {
        return is_light(channel) ? light : fractions;
    }
    // Returns the code that stores a number in a channel. The number is clamped to [0, 1].
    Code code(float number, std::size_t channel) const {
        const double clamped = static_cast<double>(std::clamp(number, 0.0F, 1.0F));
        if (!is_light(channel)) {
            // The product is exact, and so is the sum unless the product is far below 1.
            // std::lround would be slower, because it would be a function call for each number.
            // NOLINTNEXTLINE(bugprone-incorrect-roundings)
            return static_cast<Code>(clamped * static_cast<double>(kMaxCode<Code>) + 0.5);
        }
        if (sizeof(Code) == 1) {
            // NOLINTNEXTLINE(bugprone-incorrect-roundings)
            return static_cast<Code>(srgb_codes[static_cast<std::size_t>(clamped * 65535.0 + 0.5)]);
        }
        return static_cast<Code>(
            std::lround(linear_to_srgb(clamped) * static_cast<double>(kMaxCode<Code>)));
    }
};

// Sets `plane` to the numbers of one channel of a picture.
template <class Code>
void fill_plane(const Image<Code>& pixels,
                const Conversion<Code>& conversion,
                std::size_t channel,
                Image<float>& plane) {
    const std::span<const float> numbers = conversion.numbers(channel);
    const auto samples = pixels.samples();
    const auto to = plane.samples();
    for (std::size_t k = 0; k < to.size(); ++k) {
        to[k] = numbers[samples[conversion.channels * k + channel]];
    }
}

// Returns the planes of the first level that is smaller than the picture. To save memory, only the
// planes of one channel and of the opacity have the full size at the same time.
template <class Code>
Planes first_planes(const Image<Code>& pixels, const Conversion<Code>& conversion) {
    Planes planes;
    Planes colors;  // the planes of colors that are not multiplied by the opacity
    Image<float> plane(pixels.width(), pixels.height(), 1);
    Image<float> opacity;
    if (conversion.has_opacity()) {
        opacity = plane;
        fill_plane(pixels, conversion, kOpacity, opacity);
    }
    for (std::size_t c = 0; c < conversion.channels; ++c) {
        fill_plane(pixels, conversion, c, plane);
        if (conversion.has_opacity() && c < kColors) {
            colors.push_back(mean_level(plane.view(), 0));
            std::ranges::transform(
                plane.samples(), opacity.samples(), plane.samples().begin(), std::multiplies<>());
        }
        planes.push_back(mean_level(plane.view(), 0));
    }
    std::ranges::move(colors, std::back_inserter(planes));
    return planes;
}

Planes halved(const Planes& planes) {
    Planes smaller;
    for (const Image<float>& plane : planes) {
        smaller.push_back(mean_level(plane.view(), 0));
    }
    return smaller;
}

// Returns the numbers from which the codes of pixel k are computed. Normals are scaled to unit
// length and mapped to the range from 0 to 1; colors are divided by the opacity.
template <class Code>
std::array<float, 4> stored_numbers(const Planes& planes,
                                    std::size_t k,
                                    const Conversion<Code>& conversion) {
    std::array<float, 4> numbers{};
    for (std::size_t c = 0; c < conversion.channels; ++c) {
        numbers[c] = planes[c].samples()[k];
    }
    if (conversion.meaning == TexelMeaning::Normals) {
        const float length =
            std::sqrt(numbers[0] * numbers[0] + numbers[1] * numbers[1] + numbers[2] * numbers[2]);
        for (std::size_t c = 0; c < kColors; ++c) {
            const float component = length > 0.0F ? numbers[c] / length : (c == 2 ? 1.0F : 0.0F);
            numbers[c] = 0.5F * component + 0.5F;
        }
    }
    for (std::size_t c = 0; conversion.has_opacity() && c < kColors; ++c) {
        numbers[c] = numbers[kOpacity] > 0.0F ? numbers[c] / numbers[kOpacity]
                                              : planes[conversion.channels + c].samples()[k];
    }
    return numbers;
}

template <class Code>
Image<Code> codes_of(const Planes& planes, const Conversion<Code>& conversion) {
    const Image<float>& first = planes.front();
    Image<Code> codes(first.width(), first.height(), static_cast<int>(conversion.channels));
    const auto samples = codes.samples();
    for (std::size_t k = 0; k < first.samples().size(); ++k) {
        const std::array<float, 4> numbers = stored_numbers(planes, k, conversion);
        for (std::size_t c = 0; c < conversion.channels; ++c) {
            samples[conversion.channels * k + c] = conversion.code(numbers[c], c);
        }
    }
    return codes;
}

bool is_smallest(const Picture& level) {
    return level.width() == 1 && level.height() == 1;
}

Picture picture_like(const Picture& picture, Samples samples) {
    const ChannelGroup& group = picture.groups.front();
    return {{{group.names, group.type, std::move(samples)}}, picture.metadata};
}

// Appends all levels that are smaller than the picture, computed as means.
template <class Code>
void add_mean_levels(const Image<Code>& pixels,
                     TexelMeaning meaning,
                     std::vector<Picture>& levels) {
    const Conversion<Code> conversion(levels.front(), meaning);
    Planes planes;
    while (!is_smallest(levels.back())) {
        planes = planes.empty() ? first_planes(pixels, conversion) : halved(planes);
        levels.push_back(picture_like(levels.front(), codes_of(planes, conversion)));
    }
}

// Appends all levels that are smaller than the picture, computed by central_level.
template <class Code>
void add_central_levels(const Image<Code>& pixels, std::vector<Picture>& levels) {
    const auto channels = static_cast<std::size_t>(pixels.channels());
    std::vector<Image<std::uint32_t>> planes(
        channels, Image<std::uint32_t>(pixels.width(), pixels.height(), 1));
    for (std::size_t k = 0; k < pixels.samples().size(); ++k) {
        planes[k % channels].samples()[k / channels] = pixels.samples()[k];
    }
    while (!is_smallest(levels.back())) {
        for (Image<std::uint32_t>& plane : planes) {
            plane = central_level(plane.view(), 0);
        }
        Image<Code> codes(planes.front().width(), planes.front().height(), pixels.channels());
        for (std::size_t k = 0; k < codes.samples().size(); ++k) {
            codes.samples()[k] = static_cast<Code>(planes[k % channels].samples()[k / channels]);
        }
        levels.push_back(picture_like(levels.front(), std::move(codes)));
    }
}

}  // namespace

std::vector<Picture> mip_chain(const Picture& picture, TexelMeaning meaning) {
    std::vector<Picture> levels = {picture};
    std::visit(
        [&]<class Code>(const Image<Code>& pixels) {
            if constexpr (std::is_same_v<Code, std::uint8_t> ||
                          std::is_same_v<Code, std::uint16_t>) {
                if (meaning == TexelMeaning::Ids) {
                    add_central_levels(pixels, levels);
                } else {
                    add_mean_levels(pixels, meaning, levels);
                }
            }
        },
        picture.groups.front().samples);
    return levels;
}

}  // namespace foam::texgen
