#pragma once

#include <cstdint>
#include <string_view>

namespace foam::texgen {

/// Light, so that colours are mixed by plain weighted sums; primaries and white of sRGB, 1 is
/// white.
struct LinearRgb {
    double r = 0.0;
    double g = 0.0;
    double b = 0.0;

    friend bool operator==(const LinearRgb&, const LinearRgb&) = default;
};

/// A colour as an 8-bit sRGB image stores it.
struct Srgb8 {
    std::uint8_t r = 0;
    std::uint8_t g = 0;
    std::uint8_t b = 0;

    friend bool operator==(const Srgb8&, const Srgb8&) = default;
};

/// The transfer function of IEC 61966-2-1 between an encoded value and light, both in [0, 1].
double srgb_to_linear(double encoded);
double linear_to_srgb(double linear);

LinearRgb to_linear(Srgb8 color);

/// a and b by 1 - part and part.
LinearRgb mixed(const LinearRgb& a, const LinearRgb& b, double part);

/// Rounded to the nearest code; light beyond [0, 1] is clamped to it, NaN becomes 0.
Srgb8 to_srgb8(const LinearRgb& color);

/// Reads "#rrggbb", six hexadecimal digits in either case. Throws std::invalid_argument otherwise.
Srgb8 parse_color(std::string_view text);

}  // namespace foam::texgen
