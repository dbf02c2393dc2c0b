// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/image/file_io.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>

struct isal_zstream;

namespace foam::texgen {

/// The trade-off between the time of the compression and the size of its output. The decompressed
/// data are the same.
enum class Compression {
    None,   // stored blocks
    Fast,   // the size of zlib's level 1 in a fraction of its time
    Small,  // the size of zlib's level 9 in the time of its level 6
};

/// Compresses data by deflate (RFC 1951). Its buffers are reused between calls.
class Deflater {
  public:
    Deflater();
    ~Deflater();
    Deflater(Deflater&&) noexcept;
    Deflater& operator=(Deflater&&) noexcept;

    /// Returns the compressed blocks of one part of the data, valid until the next call. The blocks
    /// end at a byte boundary and refer to no earlier part, so the outputs for consecutive parts
    /// can be concatenated; the last part ends the stream. Precondition: `last` is true unless
    /// `compression` is Compression::Fast, as the others compress all of the data at once. The
    /// bytes depend on the arguments alone, but differ between versions of the libraries and may
    /// differ between processors.
    std::span<const std::byte> deflate(Compression compression,
                                       std::span<const std::byte> data,
                                       bool last = true);

  private:
    std::span<const std::byte> deflate_fast(std::span<const std::byte> data, bool last);
    void feed(std::span<const std::byte> data, int flush);
    std::span<const std::byte> deflate_whole(int level, std::span<const std::byte> data);
    void reserve_output(std::size_t size);

    std::unique_ptr<isal_zstream> stream_;
    Bytes level_buffer_;
    Bytes deflated_;
};

/// Returns the Adler-32 check sum of the data, which ends a zlib stream (RFC 1950).
std::uint32_t adler32_of(std::span<const std::byte> data);

/// Returns the Adler-32 of two consecutive parts from their check sums. `second_size` is the size
/// of the second part in bytes.
std::uint32_t joined_adler32(std::uint32_t first, std::uint32_t second, std::size_t second_size);

}  // namespace foam::texgen
