#pragma once

#include "texgen/raster/coords/fixed_point.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <limits>

namespace foam::texgen {

/// Bits of the area of a pixel. Areas are in half squares of a subpixel.
inline constexpr int kAreaBits = 2 * kSubpixelBits + 1;

inline constexpr std::int32_t kLargestMean = std::numeric_limits<std::uint16_t>::max();

/// Sums of 16-bit values times areas, per channel, in doubles, which are exact below 2^53. Channels
/// are rounded up to a power of two, with unused ones 0, so that they are vectorized.
template <std::size_t Channels>
struct ExactSums {
    using Number = double;
    using Sum = std::array<Number, std::bit_ceil(Channels)>;

    static constexpr double kPixel = std::int64_t{1} << kAreaBits;  // of coverage 1

    static Number of_area(std::int32_t area) { return area; }
    static Number of_value(std::int32_t value) { return value; }
    /// Returns what a row begins with if the value is `base` everywhere.
    static Number start(std::int32_t base) { return base * kPixel; }

    /// Returns sum / kPixel, rounded to the nearest. Clamped to the range of values, as arcs of an
    /// invalid foam may overlap.
    static std::int32_t mean(Number sum) {
        constexpr double kHalf = 0.5;  // makes truncation the nearest
        const auto mean = static_cast<std::int32_t>(sum * (1.0 / kPixel) + kHalf);
        return std::min(std::max(mean, 0), kLargestMean);
    }
};

/// Sums of areas rounded to 2^-15 pixel, in 32 bits, for means that become 8 bits. Sums wrap
/// around; values are counted from the middle of their range, which leaves half a range beyond
/// either end.
template <std::size_t Channels>
struct SmallSums {
    using Number = std::uint32_t;
    using Sum = std::array<Number, std::bit_ceil(Channels)>;

    static constexpr int kPixelBits = 15;
    static constexpr std::int32_t kMiddle = 1 << 15;

    /// Areas of whole heights are exact.
    static Number of_area(std::int32_t area) {
        constexpr int kDropped = kAreaBits - kPixelBits;
        return static_cast<Number>((area + (1 << (kDropped - 1))) >> kDropped);
    }
    static Number of_value(std::int32_t value) { return static_cast<Number>(value); }
    static Number start(std::int32_t base) {
        return static_cast<Number>((base - kMiddle) * (1 << kPixelBits));
    }

    static std::int32_t mean(Number sum) {
        constexpr Number kHalf = 1 << (kPixelBits - 1);
        const std::int32_t mean = (static_cast<std::int32_t>(sum + kHalf) >> kPixelBits) + kMiddle;
        return std::min(std::max(mean, 0), kLargestMean);
    }
};

}  // namespace foam::texgen
