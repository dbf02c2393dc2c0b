// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/image/image.h"

#include <cmath>
#include <cstdint>
#include <variant>

namespace foam::texgen {

/// Colors as linear light with the primaries of sRGB. The channels are red, green, blue and, for a
/// patch, opacity. Samples are from 0 to kWhite. Colors are straight: they are not multiplied by
/// the opacity.
struct ColorPixels {
    Image<std::uint16_t> pixels;
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

/// Numbers in the map's own unit, and the range of numbers that a PNG can store: code 0 is `low`,
/// and the largest code is `high`. A file of floating-point numbers, such as an EXR, also stores
/// numbers outside this range.
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
