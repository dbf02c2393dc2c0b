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

/// One part of the rows, with the buffers for filtering and compressing it.
struct PngPart {
    RowFilter filter;
    Deflater deflater;
    std::size_t size = 0;       // size of the filtered rows in bytes
    std::uint32_t adler32 = 1;  // checksum of the filtered rows
    std::span<const std::byte> deflated;
};

/// Compresses the filtered rows of a picture to a zlib stream, in parts that are compressed in
/// parallel. Neither the division into parts nor the bytes depend on the number of threads.
class PngData {
  public:
    /// The content of an IDAT chunk in three consecutive pieces.
    struct Chunk {
        std::span<const std::byte> begin;   // the header of the zlib stream, in the first chunk
        std::span<const std::byte> middle;  // the compressed rows
        std::span<const std::byte> end;     // the checksum of the zlib stream, in the last chunk
    };

    /// Borrows both arguments.
    PngData(const PngRows& rows, const PngEncoding& encoding);

    bool complete() const { return next_row_ == rows_.height(); }

    /// Returns the next chunks, at most one per thread. Returns no chunk if the stream is complete.
    /// The chunks are valid until the next call.
    std::span<const Chunk> next_chunks();

  private:
    int first_row(std::size_t part) const;
    void make(PngPart& part, int first, int last) const;
    Chunk chunk_of(const PngPart& part, bool first, bool last);

    const PngRows& rows_;
    const PngEncoding& encoding_;
    std::vector<PngPart> parts_;  // one per thread
    std::vector<Chunk> chunks_;
    int rows_per_part_;
    int next_row_ = 0;
    std::uint32_t adler32_ = 1;         // checksum of all rows so far
    std::array<std::byte, 4> check_{};  // adler32_ as bytes, which end the stream
};

}  // namespace foam::texgen
