// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

namespace foam::texgen {

/// Writes bits into a block of 128 bits, which are 0 at first. The first bit is the lowest bit of
/// the first byte.
class BitWriter {
  public:
    /// Appends the lowest `count` bits of `value`, the lowest bit first.
    void write(int value, int count) {
        for (int k = 0; k < count; ++k, ++position_) {
            const auto bit = static_cast<unsigned>(value) >> static_cast<unsigned>(k) & 1U;
            std::uint8_t& byte = bytes_[position_ / 8];
            byte = static_cast<std::uint8_t>(byte | bit << (position_ % 8));
        }
    }
    const std::array<std::uint8_t, 16>& bytes() const { return bytes_; }

  private:
    std::array<std::uint8_t, 16> bytes_{};
    std::size_t position_ = 0;
};

/// Reads the bits of a block in the order in which BitWriter writes them.
class BitReader {
  public:
    explicit BitReader(std::span<const std::uint8_t, 16> bytes) : bytes_(bytes) {}

    int read(int count) {
        unsigned value = 0;
        for (int k = 0; k < count; ++k, ++position_) {
            const unsigned bit = bytes_[position_ / 8] >> (position_ % 8) & 1U;
            value |= bit << static_cast<unsigned>(k);
        }
        return static_cast<int>(value);
    }

  private:
    std::span<const std::uint8_t, 16> bytes_;
    std::size_t position_ = 0;
};

}  // namespace foam::texgen
