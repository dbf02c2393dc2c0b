// SPDX-License-Identifier: Apache-2.0

#include "texgen/image/png_data.h"

#include "core/parallel/parallel_for.h"
#include "texgen/image/byte_order.h"

#include <algorithm>

// Parallel compression of one picture. The rows are divided into parts of about 512 KiB. Each
// thread filters and compresses one part at a time, independently of all other parts, and computes
// the Adler-32 checksum of the filtered bytes. The compressed parts are concatenated into one zlib
// stream (RFC 1950), which ends with the checksum of all filtered bytes. This checksum is computed
// from the checksums of the parts. Only Compression::Fast can compress parts; for the other kinds
// the whole picture is one part.

namespace foam::texgen {

namespace {

// The approximate size of a part in bytes. Parts of this size fit into the second-level cache. The
// division makes files less than 1 % larger.
constexpr std::size_t kPartBytes = std::size_t{1} << 19;

int rows_per_part(const PngRows& rows, Compression compression) {
    if (compression != Compression::Fast) {
        return rows.height();
    }
    const auto height = static_cast<std::size_t>(rows.height());
    return static_cast<int>(std::clamp<std::size_t>(kPartBytes / rows.row_bytes(), 1, height));
}

}  // namespace

PngData::PngData(const PngRows& rows, const PngEncoding& encoding, std::size_t max_bytes)
    : rows_(rows),
      encoding_(encoding),
      max_bytes_(max_bytes),
      rows_per_part_(rows_per_part(rows, encoding.compression)) {
    const int count = (rows.height() + rows_per_part_ - 1) / rows_per_part_;
    const int batch_size = std::min(thread_count(encoding.threads), count);
    parts_.resize(static_cast<std::size_t>(batch_size));
}

std::span<const PngData::Chunk> PngData::next_chunks() {
    std::size_t count = 0;
    while (count < parts_.size() && first_row(count) < rows_.height()) {
        ++count;
    }
    parallel_for(count, 1, encoding_.threads, [this](std::size_t k, std::size_t) {
        compress(parts_[k], first_row(k), first_row(k + 1));
    });
    chunks_.clear();
    for (std::size_t k = 0; k < count; ++k) {
        add_chunks(parts_[k], first_row(k) == 0, first_row(k + 1) == rows_.height());
    }
    next_row_ = first_row(count);
    return chunks_;
}

int PngData::first_row(std::size_t part) const {
    const std::size_t row =
        static_cast<std::size_t>(next_row_) + part * static_cast<std::size_t>(rows_per_part_);
    return static_cast<int>(std::min(row, static_cast<std::size_t>(rows_.height())));
}

void PngData::compress(PngPart& part, int first, int last) const {
    const std::span<const std::byte> filtered =
        part.filter.filter(rows_, encoding_.filter, first, last);
    part.size = filtered.size();
    part.adler32 = adler32_of(filtered);
    part.deflated = part.deflater.deflate(encoding_.compression, filtered, last == rows_.height());
}

void PngData::add_chunks(const PngPart& part, bool is_first, bool is_last) {
    adler32_ = joined_adler32(adler32_, part.adler32, part.size);
    check_ = big_endian(adler32_);
    std::span<const std::byte> rest = part.deflated;
    chunks_.push_back({std::span(kZlibHeader).first(is_first ? kZlibHeader.size() : 0), rest, {}});
    while (rest.size() > max_bytes_) {
        chunks_.back().middle = rest.first(max_bytes_);
        rest = rest.subspan(max_bytes_);
        chunks_.push_back({{}, rest, {}});
    }
    chunks_.back().end = std::span(check_).first(is_last ? check_.size() : 0);
}

}  // namespace foam::texgen
