// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <bit>
#include <cstdint>

namespace foam::texgen {

/// Returns the bits of the half float (16 bits, IEEE 754) nearest to a number. If two half floats
/// are equally near, returns the one whose last bit is 0. Numbers of a magnitude of at least 65520
/// become infinite. The result is that of Imath::half, also for numbers that are not finite. Unlike
/// Imath::half, the function has no branches, so that loops over it are vectorized.
[[gnu::always_inline]] inline std::uint16_t half_bits(float number) {
    constexpr std::uint32_t kSign = 0x80000000U;
    constexpr std::uint32_t kTooLarge = 0x47800000U;        // 65536
    constexpr std::uint32_t kInfinity = 0x7f800000U;        // infinity as a float
    constexpr std::uint32_t kSmallestNormal = 0x38800000U;  // 2^-14
    constexpr std::uint32_t kHalfInfinity = 0x7c00U;
    const auto bits = std::bit_cast<std::uint32_t>(number);
    const std::uint32_t sign = (bits & kSign) >> 16U;
    const std::uint32_t magnitude = bits & ~kSign;

    // The exponent is reduced by 112, and 13 bits are rounded away.
    const std::uint32_t normal =
        (magnitude - (112U << 23U) + 0xfffU + ((magnitude >> 13U) & 1U)) >> 13U;

    // Half floats below 2^-14 are multiples of 2^-24. The addition of 1/2 rounds to such a
    // multiple, because floats from 1/2 to 1 are multiples of 2^-24, too.
    const float sum = std::bit_cast<float>(magnitude) + 0.5F;
    const std::uint32_t small =
        std::bit_cast<std::uint32_t>(sum) - std::bit_cast<std::uint32_t>(0.5F);

    // The payload of a NaN is cut, but is never 0, which would be infinity.
    const std::uint32_t payload = (magnitude >> 13U) & 0x3ffU;
    const std::uint32_t nan = kHalfInfinity | payload | (payload == 0U ? 1U : 0U);

    std::uint32_t result = magnitude < kSmallestNormal ? small : normal;
    result = magnitude >= kTooLarge ? kHalfInfinity : result;
    result = magnitude > kInfinity ? nan : result;
    return static_cast<std::uint16_t>(sign | result);
}

}  // namespace foam::texgen
