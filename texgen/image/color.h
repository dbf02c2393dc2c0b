// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

namespace foam::texgen {

/// A color in linear light, so that weighted sums mix colors correctly. It has the primaries and
/// the white point of sRGB; (1, 1, 1) is white.
struct LinearRgb {
    double r = 0.0;
    double g = 0.0;
    double b = 0.0;

    friend bool operator==(const LinearRgb&, const LinearRgb&) = default;
};

/// A color as an 8-bit sRGB image stores it.
struct Srgb8 {
    std::uint8_t r = 0;
    std::uint8_t g = 0;
    std::uint8_t b = 0;

    friend bool operator==(const Srgb8&, const Srgb8&) = default;
};

/// Convert between an sRGB-encoded value and linear light by the transfer function of IEC
/// 61966-2-1. Arguments and results are in [0, 1].
double srgb_to_linear(double encoded);
double linear_to_srgb(double linear);

/// Returns the integer nearest to a sample of a 16-bit image. This takes less time than
/// std::lround. Precondition: the sample is from 0 to 65535.
inline std::uint16_t nearest_sample(float sample) {
    constexpr double kHalf = 0.5;  // added to a double, because a float could lose the last bit
    return static_cast<std::uint16_t>(static_cast<double>(sample) + kHalf);
}

/// Returns a table whose element v is the 8-bit sRGB code of the 16-bit value v of linear light.
/// The value 65535 is white. A value has the code k if 255 times its sRGB encoding rounds to k.
std::span<const std::uint8_t, 65536> srgb_codes_of_light();

/// Returns the color in linear light.
LinearRgb to_linear(Srgb8 color);

/// Returns (1 - part) a + part b.
LinearRgb mixed(const LinearRgb& a, const LinearRgb& b, double part);

/// Returns the sRGB encoding of a color, rounded to the nearest 8-bit values. Each component of the
/// color is clamped to [0, 1]; NaN becomes 0.
Srgb8 to_srgb8(const LinearRgb& color);

/// Returns the color as "#rrggbb".
std::string color_text(Srgb8 color);

/// Parses "#rrggbb", with six hexadecimal digits in either case. Throws std::invalid_argument for
/// any other text.
Srgb8 parse_color(std::string_view text);

}  // namespace foam::texgen
