// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

namespace foam::texgen {

/// Writes at most 128 bits into a block of 16 bytes, which are 0 at first. The first bit is the
/// lowest bit of the first byte.
class BitWriter {
  public:
    /// Appends the lowest `count` bits of `value`, the lowest bit first. Preconditions: `value` has
    /// no other bits, and 0 <= `count` <= 31.
    void write(int value, int count) {
        const auto field = static_cast<std::uint64_t>(value);
        if (position_ < 64) {
            low_ |= field << position_;
            high_ |= position_ > 32 ? field >> (64 - position_) : 0;
        } else {
            high_ |= field << (position_ - 64);
        }
        position_ += count;
    }
    /// Returns the block.
    std::array<std::uint8_t, 16> bytes() const {
        std::array<std::uint8_t, 16> bytes{};
        for (std::size_t k = 0; k < 8; ++k) {
            bytes[k] = static_cast<std::uint8_t>(low_ >> (8 * k));
            bytes[k + 8] = static_cast<std::uint8_t>(high_ >> (8 * k));
        }
        return bytes;
    }

  private:
    std::uint64_t low_ = 0;
    std::uint64_t high_ = 0;
    int position_ = 0;
};

/// Reads the bits of a block in the order in which BitWriter writes them.
class BitReader {
  public:
    explicit BitReader(std::span<const std::uint8_t, 16> bytes) {
        for (std::size_t k = 8; k-- > 0;) {
            low_ = low_ << 8U | bytes[k];
            high_ = high_ << 8U | bytes[k + 8];
        }
    }

    /// Returns the next `count` bits. Precondition: 0 <= `count` <= 31.
    int read(int count) {
        if (count == 0) {
            return 0;
        }
        const auto value = static_cast<int>(low_ & ((std::uint64_t{1} << count) - 1));
        low_ = low_ >> count | high_ << (64 - count);
        high_ >>= count;
        return value;
    }

  private:
    std::uint64_t low_ = 0;
    std::uint64_t high_ = 0;
};

}  // namespace foam::texgen
