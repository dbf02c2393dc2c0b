// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/files/file_io.h"
#include "texgen/image/byte_order.h"

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <span>

namespace foam::texgen {

/// Appends an unsigned integer, the least significant byte first.
template <std::unsigned_integral Number>
void append_number(Bytes& bytes, Number number) {
    const auto more = little_endian(number);
    bytes.insert(bytes.end(), more.begin(), more.end());
}

/// Reads a stream of bytes from the start. The bytes must outlive the reader.
class ByteReader {
  public:
    explicit ByteReader(std::span<const std::byte> bytes) : rest_(bytes) {}

    /// Returns the number of bytes that have not been read.
    std::size_t remaining() const { return rest_.size(); }

    /// Reads the next `count` bytes. Throws InputError if fewer bytes remain.
    std::span<const std::byte> take(std::size_t count) {
        if (count > rest_.size()) {
            throw InputError("the file ends too early");
        }
        const auto taken = rest_.first(count);
        rest_ = rest_.subspan(count);
        return taken;
    }

    /// Reads an unsigned integer of `Number`'s size, the least significant byte first. Throws
    /// InputError if fewer bytes remain.
    template <class Number = std::uint32_t>
    Number number() {
        Number value = 0;
        std::size_t shift = 0;
        for (const std::byte byte : take(sizeof(Number))) {
            value |= static_cast<Number>(std::to_integer<Number>(byte) << shift);
            shift += 8;
        }
        return value;
    }

  private:
    std::span<const std::byte> rest_;
};

}  // namespace foam::texgen
