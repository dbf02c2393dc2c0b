#pragma once

#include "texgen/image/image.h"

#include <cmath>
#include <cstdint>
#include <variant>

namespace foam::texgen {

/// Colours as light, kWhite being white, primaries of sRGB: red, green, blue and, of a patch, an
/// opacity. Colours are straight: not premultiplied.
struct ColorPixels {
    Image<std::uint16_t> pixels;
};

inline constexpr double kWhite = 65535.0;

/// Light from 0 to 1 as ColorPixels has it.
inline std::uint16_t light_step(double light) {
    return static_cast<std::uint16_t>(std::lround(light * kWhite));
}

/// Numbers in the map's own unit, and those that the ends of a PNG's codes stand for. A file of
/// floats takes them as they are, beyond that range too.
struct NumberPixels {
    Image<float> pixels;
    double low = 0.0;
    double high = 1.0;
};

/// Integers that must not be mixed, such as ids.
struct IdPixels {
    Image<std::uint32_t> pixels;
};

/// What a map is before a file format makes codes of it.
using MapImage = std::variant<ColorPixels, NumberPixels, IdPixels>;

}  // namespace foam::texgen
