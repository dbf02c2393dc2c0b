// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <array>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <span>

namespace foam::texgen {

/// Returns the bytes of an unsigned integer, the most significant byte first.
template <std::unsigned_integral Number>
std::array<std::byte, sizeof(Number)> big_endian(Number number) {
    std::array<std::byte, sizeof(Number)> bytes{};
    for (std::size_t k = 0; k < bytes.size(); ++k) {
        bytes[k] = static_cast<std::byte>(number >> (8 * (bytes.size() - 1 - k)));
    }
    return bytes;
}

/// Returns the bytes of an unsigned integer, the least significant byte first.
template <std::unsigned_integral Number>
std::array<std::byte, sizeof(Number)> little_endian(Number number) {
    std::array<std::byte, sizeof(Number)> bytes{};
    for (std::size_t k = 0; k < bytes.size(); ++k) {
        bytes[k] = static_cast<std::byte>(number >> (8 * k));
    }
    return bytes;
}

/// Returns the number in the first four bytes, the most significant byte first. Precondition: there
/// are at least four bytes.
inline std::uint32_t from_big_endian(std::span<const std::byte> bytes) {
    std::uint32_t number = 0;
    for (const std::byte byte : bytes.first(4)) {
        number = number << 8U | std::to_integer<std::uint32_t>(byte);
    }
    return number;
}

}  // namespace foam::texgen
