#pragma once

#include "texgen/image/file_io.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>

struct isal_zstream;

namespace foam::texgen {

/// How much work goes into a smaller file; what is decompressed is the same.
enum class Compression {
    None,   // stored as it is
    Fast,   // as small as zlib's level 1, in a fraction of its time
    Small,  // as small as zlib's level 9, in the time of its level 6
};

/// Compresses data by deflate (RFC 1951), time and again with the same buffers.
class Deflater {
  public:
    Deflater();
    ~Deflater();
    Deflater(Deflater&&) noexcept;
    Deflater& operator=(Deflater&&) noexcept;

    /// Whole blocks up to a byte's end that refer to nothing before them, so that those of one part
    /// of the data may follow those of the part before; the last part ends the stream. Only
    /// Compression::Fast makes parts: the others need the whole of the data at once, which then is
    /// the last part. Valid until the next call. The bytes depend on nothing but the arguments, but
    /// differ between versions of the libraries, and may between processors.
    std::span<const std::byte> deflate(Compression compression,
                                       std::span<const std::byte> data,
                                       bool last = true);

  private:
    std::span<const std::byte> deflate_fast(std::span<const std::byte> data, bool last);
    void feed(std::span<const std::byte> data, int flush);
    std::span<const std::byte> deflate_whole(int level, std::span<const std::byte> data);
    void make_room(std::size_t size);

    std::unique_ptr<isal_zstream> stream_;
    Bytes level_buffer_;
    Bytes deflated_;
};

/// The check sum at the end of a zlib stream (RFC 1950).
std::uint32_t adler32_of(std::span<const std::byte> data);

/// That of two parts in a row; `second_size` is the second part's in bytes.
std::uint32_t joined_adler32(std::uint32_t first, std::uint32_t second, std::size_t second_size);

}  // namespace foam::texgen
