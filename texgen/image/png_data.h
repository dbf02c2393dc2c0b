#pragma once

#include "texgen/image/png.h"
#include "texgen/image/png_filter.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace foam::texgen {

/// Rows on their way into a zlib stream, and the buffers for it.
struct PngPart {
    RowFilter filter;
    Deflater deflater;
    std::size_t size = 0;  // in bytes, filtered
    std::uint32_t adler32 = 1;
    std::span<const std::byte> deflated;
};

/// The filtered rows of a picture as a zlib stream, in parts that are compressed in parallel. How
/// the rows are divided does not depend on the number of threads, so neither do the bytes.
class PngData {
  public:
    /// The content of an IDAT chunk, in three pieces.
    struct Chunk {
        std::span<const std::byte> begin;
        std::span<const std::byte> middle;
        std::span<const std::byte> end;
    };

    /// Borrows both arguments.
    PngData(const PngRows& rows, const PngEncoding& encoding);

    bool complete() const { return next_row_ == rows_.height(); }

    /// As many chunks as there are threads, while there are any; valid until the next call.
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
    std::uint32_t adler32_ = 1;         // of all rows so far
    std::array<std::byte, 4> check_{};  // the stream's last bytes
};

}  // namespace foam::texgen
