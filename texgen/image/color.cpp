// SPDX-License-Identifier: Apache-2.0

#include "texgen/image/color.h"

#include "core/geometry/elementary.h"

#include <fmt/core.h>

#include <array>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <stdexcept>

namespace foam::texgen {

namespace {

using Encoding = std::array<std::uint8_t, 65536>;

// Returns the sRGB codes of the values 0 to 65535 of linear light. The sRGB encoding of a value is
// a number from 0 to 1. The value has the code k if this number is at least (k - 1/2) / 255 and
// less than (k + 1/2) / 255.
Encoding make_srgb_encoding() {
    constexpr double kWhite = 65535.0;
    Encoding encoding{};
    std::size_t value = 0;
    for (int code = 0; code < 256; ++code) {
        const double end =
            code < 255 ? srgb_to_linear((code + 0.5) / 255.0) * kWhite : kWhite + 1.0;
        for (; value < encoding.size() && static_cast<double>(value) < end; ++value) {
            encoding[value] = static_cast<std::uint8_t>(code);
        }
    }
    return encoding;
}

// The end of the linear segment of the sRGB transfer function, as an encoded value and as linear
// light.
constexpr double kToeEncoded = 0.04045;
constexpr double kToeLinear = 0.0031308;

/// Returns the sRGB code nearest to a value of linear light. The value is clamped to [0, 1]; NaN
/// counts as 0.
std::uint8_t to_code(double linear) {
    if (!(linear > 0.0)) {
        return 0;
    }
    return static_cast<std::uint8_t>(std::lround(255.0 * linear_to_srgb(std::fmin(linear, 1.0))));
}

bool parse_hex(std::string_view digits, std::uint32_t& value) {
    const auto [end, error] =
        std::from_chars(digits.data(), digits.data() + digits.size(), value, 16);
    return error == std::errc{} && end == digits.data() + digits.size();
}

}  // namespace

double srgb_to_linear(double encoded) {
    return encoded <= kToeEncoded ? encoded / 12.92 : ieee::pow((encoded + 0.055) / 1.055, 2.4);
}

double linear_to_srgb(double linear) {
    return linear <= kToeLinear ? 12.92 * linear : 1.055 * ieee::pow(linear, 1.0 / 2.4) - 0.055;
}

std::span<const std::uint8_t, 65536> srgb_codes_of_light() {
    static const Encoding encoding = make_srgb_encoding();
    return encoding;
}

LinearRgb to_linear(Srgb8 color) {
    return {srgb_to_linear(color.r / 255.0),
            srgb_to_linear(color.g / 255.0),
            srgb_to_linear(color.b / 255.0)};
}

LinearRgb mixed(const LinearRgb& a, const LinearRgb& b, double part) {
    return {std::lerp(a.r, b.r, part), std::lerp(a.g, b.g, part), std::lerp(a.b, b.b, part)};
}

Srgb8 to_srgb8(const LinearRgb& color) {
    return {to_code(color.r), to_code(color.g), to_code(color.b)};
}

std::string color_text(Srgb8 color) {
    return fmt::format("#{:02x}{:02x}{:02x}", color.r, color.g, color.b);
}

Srgb8 parse_color(std::string_view text) {
    std::uint32_t packed = 0;
    if (text.size() != 7 || text.front() != '#' || !parse_hex(text.substr(1), packed)) {
        throw std::invalid_argument(
            fmt::format("color '{}': must be '#rrggbb', six hexadecimal digits", text));
    }
    return {static_cast<std::uint8_t>(packed >> 16),
            static_cast<std::uint8_t>((packed >> 8) & 0xff),
            static_cast<std::uint8_t>(packed & 0xff)};
}

}  // namespace foam::texgen
