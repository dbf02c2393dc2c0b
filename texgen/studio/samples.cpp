// SPDX-License-Identifier: Apache-2.0

#include "texgen/studio/samples.h"

#include <cstddef>
#include <cstring>
#include <variant>
#include <vector>

namespace foam::texgen {

namespace {

constexpr std::uint8_t kOpaque = 255;

}  // namespace

float number_of(const MapImage& image, int x, int y, int channel) {
    const auto index = static_cast<std::size_t>(channel);
    if (const auto* colors = std::get_if<ColorPixels>(&image)) {
        return static_cast<float>(colors->pixels.pixel(x, y)[index] / kWhite);
    }
    if (const auto* ids = std::get_if<IdPixels>(&image)) {
        return static_cast<float>(ids->pixels.pixel(x, y)[index]);
    }
    return std::get<NumberPixels>(image).pixels.pixel(x, y)[index];
}

MapSize size_of(const MapImage& image) {
    return std::visit(
        [](const auto& pixels) {
            return MapSize{pixels.pixels.width(), pixels.pixels.height(), pixels.pixels.channels()};
        },
        image);
}

std::string floats_from_top(const MapImage& image) {
    const MapSize size = size_of(image);
    std::vector<float> floats;
    for (int y = size.height - 1; y >= 0; --y) {
        for (int x = 0; x < size.width; ++x) {
            for (int channel = 0; channel < size.channels; ++channel) {
                floats.push_back(number_of(image, x, y, channel));
            }
        }
    }
    std::string bytes(floats.size() * sizeof(float), '\0');
    std::memcpy(bytes.data(), floats.data(), bytes.size());
    return bytes;
}

std::string rgba_from_top(const Image<std::uint8_t>& codes) {
    const int channels = codes.channels();
    const int green = channels == 1 ? 0 : 1;
    const int blue = channels == 1 ? 0 : 2;
    std::string bytes(
        static_cast<std::size_t>(codes.width()) * static_cast<std::size_t>(codes.height()) * kRgba,
        '\0');
    char* to = bytes.data();
    for (int y = codes.height() - 1; y >= 0; --y) {
        const std::uint8_t* from = codes.row(y).data();
        for (int x = 0; x < codes.width(); ++x, from += channels, to += kRgba) {
            to[0] = static_cast<char>(from[0]);
            to[1] = static_cast<char>(from[green]);
            to[2] = static_cast<char>(from[blue]);
            to[3] = static_cast<char>(channels == kRgba ? from[3] : kOpaque);
        }
    }
    return bytes;
}

}  // namespace foam::texgen
