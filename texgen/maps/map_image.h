// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/image/color.h"
#include "texgen/image/image.h"

#include <array>
#include <cmath>
#include <cstdint>
#include <span>
#include <variant>

namespace foam::texgen {

/// Colors as linear light with the primaries of sRGB. The channels are red, green, blue and, for a
/// patch, opacity. Samples are from 0 to kWhite. Colors are straight: they are not multiplied by
/// the opacity. The functions that draw single maps (Map::draw) may leave any color in pixels
/// without opacity; the function `draw` of cross_fade.h replaces it (bleed_colors).
struct ColorPixels {
    Image<std::uint16_t> pixels;
    // The color of all pixels if no pixel has an opacity above 0 (bleed_colors).
    std::array<std::uint16_t, 3> fallback{};
};

/// The sample of full opacity, and of each color channel of white.
inline constexpr double kWhite = 65535.0;

/// The number of channels of ColorPixels with an opacity: red, green, blue and opacity.
inline constexpr int kChannelsWithOpacity = 4;

/// Returns light or an opacity as a sample of ColorPixels, rounded to nearest. Precondition:
/// `light` is from 0 to 1.
inline std::uint16_t to_sample(double light) {
    return static_cast<std::uint16_t>(std::lround(light * kWhite));
}

/// Writes a color to the first three channels of a pixel of ColorPixels. If there is a fourth
/// channel, writes the opacity to it.
inline void write_pixel(const LinearRgb& color, double opacity, std::span<std::uint16_t> pixel) {
    pixel[0] = to_sample(color.r);
    pixel[1] = to_sample(color.g);
    pixel[2] = to_sample(color.b);
    if (pixel.size() > 3) {
        pixel[3] = to_sample(opacity);
    }
}

/// Numbers in the map's own unit, and the range of numbers that a PNG can store: code 0 (the
/// smallest integer sample) stands for `low`, and the largest code for `high`. A file of
/// floating-point numbers, such as an EXR, also stores numbers outside this range.
struct NumberPixels {
    Image<float> pixels;
    double low = 0.0;
    double high = 1.0;
};

/// Integers that must not be mixed, such as ids.
struct IdPixels {
    Image<std::uint32_t> pixels;
};

/// The image of a map before it is encoded for a file format.
using MapImage = std::variant<ColorPixels, NumberPixels, IdPixels>;

}  // namespace foam::texgen
