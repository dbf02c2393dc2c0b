// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/image/png.h"
#include "texgen/image/png_filter.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace foam::texgen {

/// One part of the rows of a picture, with the buffers for filtering and compressing it.
struct PngPart {
    RowFilter filter;
    Deflater deflater;
    std::size_t size = 0;                 // size of the filtered rows in bytes
    std::uint32_t adler32 = 1;            // Adler-32 checksum of the filtered rows
    std::span<const std::byte> deflated;  // the compressed rows, in the memory of `deflater`
};

/// Filters the rows of a picture and compresses them to a zlib stream (RFC 1950). The rows are
/// divided into parts, which are compressed in parallel. Neither the division nor the bytes depend
/// on the number of threads.
class PngData {
  public:
    /// The default limit for the compressed rows in a chunk, in bytes. It is well below the limit
    /// of PNG, which is 2^31 - 1 bytes for a whole chunk.
    static constexpr std::size_t kDefaultChunkBytes = std::size_t{1} << 30;

    /// The content of an IDAT chunk in three consecutive pieces.
    struct Chunk {
        std::span<const std::byte> begin;   // zlib header; empty except in the first chunk
        std::span<const std::byte> middle;  // the compressed rows
        std::span<const std::byte> end;     // zlib checksum; empty except in the last chunk
    };

    /// Refers to the rows and the encoding, which must outlive this object. A chunk has at most
    /// `max_bytes` bytes of compressed rows.
    PngData(const PngRows& rows,
            const PngEncoding& encoding,
            std::size_t max_bytes = kDefaultChunkBytes);

    /// Returns true if next_chunks has returned all chunks of the stream.
    bool complete() const { return next_row_ == rows_.height(); }

    /// Compresses the next parts, at most one per thread, and returns their chunks: one per part,
    /// or more if the part is too large for a chunk. Returns no chunk if the stream is complete.
    /// The chunks are valid until the next call.
    std::span<const Chunk> next_chunks();

  private:
    // Returns the first row of a part, counted from the top. Part 0 is the next part to compress.
    int first_row(std::size_t part) const;
    // Filters and compresses the rows first, first + 1, ..., last - 1.
    void compress(PngPart& part, int first, int last) const;
    // Adds the chunks of a compressed part, and adds the part to the checksum. Must be called for
    // the parts in the order of the rows. `is_first` and `is_last` are true for the first and the
    // last part of the picture.
    void add_chunks(const PngPart& part, bool is_first, bool is_last);

    const PngRows& rows_;
    const PngEncoding& encoding_;
    std::size_t max_bytes_;
    std::vector<PngPart> parts_;  // the parts that one call of next_chunks compresses
    std::vector<Chunk> chunks_;   // the chunks of these parts
    int rows_per_part_;
    int next_row_ = 0;
    std::uint32_t adler32_ = 1;         // checksum of all rows that have been compressed
    std::array<std::byte, 4> check_{};  // adler32_ as bytes, which end the stream
};

}  // namespace foam::texgen
