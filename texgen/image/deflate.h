// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/files/file_io.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>

struct isal_zstream;

namespace foam::texgen {

/// The trade-off between the time of compression and the size of its output.
enum class Compression {
    None,   // no compression: stored blocks
    Fast,   // output about as large as from zlib at level 1, at least 4 times as fast
    Small,  // output about as large as from zlib at level 9, at least as fast as zlib at level 6
};

/// Compresses data to the deflate format (RFC 1951). Its buffers are reused between calls.
class Deflater {
  public:
    Deflater();
    ~Deflater();
    Deflater(Deflater&&) noexcept;
    Deflater& operator=(Deflater&&) noexcept;

    /// Compresses one part of a stream. Returns the compressed blocks, valid until the next call.
    /// The blocks end at a byte boundary and do not refer to earlier parts, so the outputs for
    /// consecutive parts can be concatenated. If `last` is true, the blocks end the stream. On one
    /// machine the returned bytes depend only on the arguments. The bytes can differ between
    /// versions of the libraries and between processors. Precondition: `compression` is
    /// Compression::Fast or `last` is true, because only Fast can compress a stream in parts.
    std::span<const std::byte> deflate(Compression compression,
                                       std::span<const std::byte> data,
                                       bool last = true);

    /// Compresses data and returns the zlib stream (RFC 1950). `level` is from 1 (fastest) to 9
    /// (smallest); the stream is about as large as from zlib at the same level. Level 2 gives the
    /// same stream as level 1. As for Compression::Fast, this stream can differ between processors.
    Bytes zlib_stream(int level, std::span<const std::byte> data);

  private:
    std::span<const std::byte> deflate_fast(std::span<const std::byte> data, bool last);
    void feed(std::span<const std::byte> data, int flush);
    std::span<const std::byte> deflate_whole(int level, std::span<const std::byte> data);
    void reserve_output(std::size_t size);

    std::unique_ptr<isal_zstream> stream_;
    Bytes level_buffer_;
    Bytes deflated_;
};

/// The first bytes of a zlib stream (RFC 1950). They mean: compressed by deflate with a window of
/// 32 KiB.
inline constexpr std::array<std::byte, 2> kZlibHeader = {std::byte{0x78}, std::byte{0x01}};

/// Returns the Adler-32 checksum of the data. A zlib stream ends with such a checksum (RFC 1950).
std::uint32_t adler32_of(std::span<const std::byte> data);

/// Returns the Adler-32 checksum of two consecutive parts, given the checksums of the parts.
/// `second_size` is the size of the second part in bytes.
std::uint32_t joined_adler32(std::uint32_t first, std::uint32_t second, std::size_t second_size);

}  // namespace foam::texgen
