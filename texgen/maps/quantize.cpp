// SPDX-License-Identifier: Apache-2.0

#include "texgen/maps/quantize.h"

#include "texgen/image/color.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

namespace foam::texgen {

namespace {

// Returns the 8-bit code nearest to a 16-bit opacity. 65535 is 257 times 255.
std::uint8_t opacity_code(std::uint32_t opacity) {
    return static_cast<std::uint8_t>((opacity + 128) / 257);
}

template <class Code>
Image<Code> number_codes(const NumberPixels& numbers) {
    constexpr double kMaxCode = std::numeric_limits<Code>::max();
    constexpr double kHalf = 0.5;  // rounds positive numbers if it is added before truncation
    const double scale = kMaxCode / (numbers.high - numbers.low);
    const auto code_of = [&](float number) {
        const double code = (static_cast<double>(number) - numbers.low) * scale;
        return code > 0.0 ? static_cast<Code>(std::min(code, kMaxCode) + kHalf) : Code{0};
    };
    const Image<float>& from = numbers.pixels;
    const auto channels = static_cast<std::size_t>(from.channels());
    Image<Code> codes(from.width(), from.height(), from.channels() == 2 ? 3 : from.channels());
    auto to = codes.samples().begin();
    for (auto pixel = from.samples(); !pixel.empty(); pixel = pixel.subspan(channels)) {
        std::transform(pixel.begin(), pixel.begin() + from.channels(), to, code_of);
        to += codes.channels();
    }
    return codes;
}

template <class Code>
Image<Code> id_codes(const IdPixels& ids) {
    const Image<std::uint32_t>& from = ids.pixels;
    Image<Code> codes(from.width(), from.height(), from.channels());
    std::transform(from.samples().begin(),
                   from.samples().end(),
                   codes.samples().begin(),
                   [](std::uint32_t id) { return static_cast<Code>(id); });
    return codes;
}

template <class Code>
CodedImage data_codes(const MapImage& map) {
    if (const auto* numbers = std::get_if<NumberPixels>(&map)) {
        return {number_codes<Code>(*numbers), false};
    }
    return {id_codes<Code>(std::get<IdPixels>(map)), false};
}

}  // namespace

Image<std::uint8_t> srgb_codes(const ColorPixels& colors) {
    const auto encoding = srgb_codes_of_light();
    const Image<std::uint16_t>& from = colors.pixels;
    Image<std::uint8_t> codes(from.width(), from.height(), from.channels());
    const auto light = from.samples();
    const auto coded = codes.samples();
    std::transform(light.begin(), light.end(), coded.begin(), [&](std::uint16_t value) {
        return encoding[value];
    });
    if (from.channels() == kChannelsWithOpacity) {
        for (std::size_t k = kChannelsWithOpacity - 1; k < light.size();
             k += kChannelsWithOpacity) {
            coded[k] = opacity_code(light[k]);
        }
    }
    return codes;
}

CodedImage quantize(const MapImage& map, int bits) {
    if (const auto* colors = std::get_if<ColorPixels>(&map)) {
        return {srgb_codes(*colors), true};
    }
    return bits == 8 ? data_codes<std::uint8_t>(map) : data_codes<std::uint16_t>(map);
}

}  // namespace foam::texgen
