// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/files/file_io.h"

#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>
#include <span>
#include <stdexcept>
#include <type_traits>

namespace foam::texgen {

/// The exception for content of a file that ends too early, is malformed, or is not of the expected
/// kind. The message gives the reason, but no file name.
class BadContent : public std::runtime_error {
    using runtime_error::runtime_error;
};

static_assert(std::endian::native == std::endian::little, "numbers have their lowest byte first");

/// Appends numbers to a buffer, in little-endian order.
class ByteWriter {
  public:
    /// Appends the sizeof(Number) bytes of a number.
    template <class Number>
    requires std::is_arithmetic_v<Number>
    void put(Number number) {
        const std::size_t end = bytes_.size();
        bytes_.resize(end + sizeof(Number));
        std::memcpy(bytes_.data() + end, &number, sizeof(Number));
    }

    const Bytes& bytes() const { return bytes_; }

  private:
    Bytes bytes_;
};

/// Reads the numbers that a ByteWriter wrote. The functions that read throw BadContent if the bytes
/// end too early.
class ByteReader {
  public:
    explicit ByteReader(std::span<const std::byte> bytes) : rest_(bytes) {}

    /// Reads a number of the given type.
    template <class Number>
    requires std::is_arithmetic_v<Number> Number take() {
        check_left(1, sizeof(Number));
        Number number{};
        std::memcpy(&number, rest_.data(), sizeof(Number));
        rest_ = rest_.subspan(sizeof(Number));
        return number;
    }

    /// Reads a number of 32 bits: the count of the elements that follow it. Each element takes at
    /// least `bytes_each` bytes. Throws BadContent if the remaining bytes are too few for these
    /// elements.
    std::size_t take_count(std::size_t bytes_each) {
        const auto count = take<std::uint32_t>();
        check_left(count, bytes_each);
        return count;
    }

    /// Reads an integer of 32 bits. Throws BadContent if it is not from `low` to `high`.
    std::int32_t take_integer(std::int64_t low,
                              std::int64_t high = std::numeric_limits<std::int32_t>::max()) {
        const auto integer = take<std::int32_t>();
        if (integer < low || integer > high) {
            throw BadContent("an integer is out of range");
        }
        return integer;
    }

    /// Reads an index of 32 bits. Throws BadContent if the index is not below `limit`.
    std::uint32_t take_index(std::size_t limit) {
        const auto index = take<std::uint32_t>();
        if (index >= limit) {
            throw BadContent("an index is out of range");
        }
        return index;
    }

    bool is_at_end() const { return rest_.empty(); }

  private:
    void check_left(std::size_t count, std::size_t bytes_each) const {
        if (count > rest_.size() / bytes_each) {
            throw BadContent("unexpected end of the file");
        }
    }

    std::span<const std::byte> rest_;
};

}  // namespace foam::texgen
