// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/image/image.h"

#include <cmath>
#include <cstdint>
#include <variant>

namespace foam::texgen {

/// Colors as linear light with the primaries of sRGB: red, green, blue and, for a patch, an
/// opacity. White and full opacity are kWhite. Colors are straight: not premultiplied.
struct ColorPixels {
    Image<std::uint16_t> pixels;
};

inline constexpr double kWhite = 65535.0;

/// Converts light from 0 to 1 to the integers of ColorPixels.
inline std::uint16_t light_step(double light) {
    return static_cast<std::uint16_t>(std::lround(light * kWhite));
}

/// Numbers in the map's own unit, and the range of numbers that a PNG can store: code 0 is `low`,
/// and the largest code is `high`. A file of floats stores all numbers unchanged, including numbers
/// outside that range.
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
