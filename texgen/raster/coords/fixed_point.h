// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/geometry/vec2.h"

#include <cstdint>

namespace foam::texgen {

/// The binary logarithm of kSubpixel.
inline constexpr int kSubpixelBits = 10;
/// The side of a pixel in subpixels. A subpixel is the unit of length of the rasterizer's integer
/// coordinates.
inline constexpr std::int32_t kSubpixel = 1 << kSubpixelBits;

/// A point or a vector in subpixels. x points right, y up.
struct SubpixelPoint {
    std::int32_t x = 0;
    std::int32_t y = 0;

    friend SubpixelPoint operator+(SubpixelPoint a, SubpixelPoint b) {
        return {a.x + b.x, a.y + b.y};
    }
    friend SubpixelPoint operator-(SubpixelPoint a, SubpixelPoint b) {
        return {a.x - b.x, a.y - b.y};
    }
    friend bool operator==(SubpixelPoint a, SubpixelPoint b) = default;
};

/// Convert a coordinate or a point in pixels to the nearest subpixel. Ties are rounded up.
/// Precondition: |pixels| < 2^16.
inline std::int32_t to_subpixel(double pixels) {
    constexpr std::int32_t kBias = 1 << 26;  // makes the sum positive, so that truncation is floor
    return static_cast<std::int32_t>(pixels * kSubpixel + (kBias + 0.5)) - kBias;
}

inline SubpixelPoint to_subpixel(const Vec2& pixels) {
    return {to_subpixel(pixels.x()), to_subpixel(pixels.y())};
}

/// Converts a point in pixels to the nearest subpixel, without a limit. The coordinates of the
/// result are whole numbers, stored as doubles because they may not fit into 32 bits.
inline Vec2 rounded_to_subpixels(const Vec2& pixels) {
    return (kSubpixel * pixels.array() + 0.5).floor().matrix();
}

/// Returns the column (row) of pixels that contains an x (y) coordinate in subpixels.
inline std::int32_t pixel_of(std::int32_t subpixel) {
    return subpixel >> kSubpixelBits;
}

/// Returns the largest integer that is at most n / d. Precondition: d > 0.
inline std::int32_t floor_div(std::int32_t n, std::int32_t d) {
    return n / d - (n % d < 0 ? 1 : 0);
}

/// Returns n modulo d, in [0, d): the remainder of floor_div. Precondition: d > 0.
inline std::int32_t wrap(std::int32_t n, std::int32_t d) {
    return n - floor_div(n, d) * d;
}

}  // namespace foam::texgen
