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

/// Reads a stream of bytes from the start. Every function throws InputError if the stream ends too
/// early.
class ByteReader {
  public:
    explicit ByteReader(std::span<const std::byte> bytes) : rest_(bytes) {}

    std::size_t remaining() const { return rest_.size(); }

    std::span<const std::byte> take(std::size_t count) {
        if (count > rest_.size()) {
            throw InputError("the file ends too early");
        }
        const auto taken = rest_.first(count);
        rest_ = rest_.subspan(count);
        return taken;
    }

    /// Reads an unsigned integer of `Number`'s size, the least significant byte first.
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
