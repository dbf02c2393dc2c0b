// SPDX-License-Identifier: Apache-2.0

#include "texgen/image/deflate.h"

#include "texgen/image/byte_order.h"

#include <isa-l/igzip_lib.h>
#include <libdeflate.h>
#include <zlib.h>

#include <algorithm>
#include <cassert>
#include <new>
#include <stdexcept>

namespace foam::texgen {

namespace {

// The level of ISA-L, 0 to 3, for Compression::Fast. At level 3, files are 1 % smaller than at
// level 2, but compression takes 2 to 6 times as long.
constexpr int kFastLevel = 2;
// The largest level of Deflater::zlib_stream at which ISA-L is used instead of libdeflate. Up to
// this level, the streams of ISA-L have the same size as those of libdeflate, within 5 %, but take
// a third of the time.
constexpr int kMaxIsalLevel = 2;
// The level of libdeflate, 0 to 12, for Compression::Small; level 0 stores without compression. At
// level 9, files are 1 % smaller than at level 7, but compression takes 2 to 4 times as long.
constexpr int kSmallLevel = 7;

// ISA-L compresses each part of the data (one call of deflate_fast) as a stream of its own. This
// number of bytes at the start of each part is compressed and flushed separately. This avoids an
// error in the main loop of ISA-L 2.30 (igzip_icf_body_h1_gr_bt.asm, .write_first_byte). At the
// start of a stream, this loop should hash the input bytes from the third byte on. Instead, it
// hashes a register that still contains the address of the stream object. The matches that ISA-L
// finds therefore sometimes depend on this address. An input of 4 bytes is processed only by the
// loop for the end of the data. That loop needs at least 4 bytes, and has no such error.
constexpr std::size_t kFirstBytes = 4;

// Returns an upper bound, in bytes, of the compressed size of `size` bytes. If data cannot be
// compressed, stored blocks add 5 bytes per 65,535 bytes, and blocks with dynamic Huffman codes add
// less than 1/8 of the size. The beginning and the end of a stream add less than 4096 bytes.
std::size_t max_deflated_size(std::size_t size) {
    return size + size / 8 + 4096;
}

// Casts away const for the C libraries, which never write to their input.
std::uint8_t* input_of(std::span<const std::byte> data) {
    return const_cast<std::uint8_t*>(reinterpret_cast<const std::uint8_t*>(data.data()));
}

struct FreeCompressor {
    void operator()(libdeflate_compressor* compressor) const {
        libdeflate_free_compressor(compressor);
    }
};
using Compressor = std::unique_ptr<libdeflate_compressor, FreeCompressor>;

}  // namespace

Deflater::Deflater() = default;
Deflater::~Deflater() = default;
Deflater::Deflater(Deflater&&) noexcept = default;
Deflater& Deflater::operator=(Deflater&&) noexcept = default;

std::span<const std::byte> Deflater::deflate(Compression compression,
                                             std::span<const std::byte> data,
                                             bool last) {
    if (compression == Compression::Fast) {
        return deflate_fast(data, last);
    }
    assert(last);
    return deflate_whole(compression == Compression::Small ? kSmallLevel : 0, data);
}

std::span<const std::byte> Deflater::deflate_fast(std::span<const std::byte> data, bool last) {
    if (stream_ == nullptr) {
        stream_ = std::make_unique<isal_zstream>();
        level_buffer_.resize(ISAL_DEF_LVL2_EXTRA_LARGE);
    }
    reserve_output(max_deflated_size(data.size()));
    isal_deflate_init(stream_.get());
    stream_->level = kFastLevel;
    stream_->level_buf = reinterpret_cast<std::uint8_t*>(level_buffer_.data());
    stream_->level_buf_size = static_cast<std::uint32_t>(level_buffer_.size());
    stream_->next_out = reinterpret_cast<std::uint8_t*>(deflated_.data());
    stream_->avail_out = static_cast<std::uint32_t>(deflated_.size());
    if (data.size() > kFirstBytes) {
        feed(data.first(kFirstBytes), SYNC_FLUSH);
        data = data.subspan(kFirstBytes);
    }
    stream_->end_of_stream = last ? 1 : 0;
    feed(data, last ? NO_FLUSH : FULL_FLUSH);
    return std::span(deflated_).first(stream_->total_out);
}

void Deflater::feed(std::span<const std::byte> data, int flush) {
    stream_->flush = static_cast<std::uint16_t>(flush);
    stream_->next_in = input_of(data);
    stream_->avail_in = static_cast<std::uint32_t>(data.size());
    if (isal_deflate(stream_.get()) != COMP_OK || stream_->avail_in != 0 ||
        stream_->avail_out == 0) {
        throw std::logic_error("the compressed data does not fit into its buffer");
    }
}

std::span<const std::byte> Deflater::deflate_whole(int level, std::span<const std::byte> data) {
    const Compressor compressor(libdeflate_alloc_compressor(level));
    if (compressor == nullptr) {
        throw std::bad_alloc();
    }
    reserve_output(libdeflate_deflate_compress_bound(compressor.get(), data.size()));
    const std::size_t size = libdeflate_deflate_compress(
        compressor.get(), data.data(), data.size(), deflated_.data(), deflated_.size());
    return std::span(deflated_).first(size);
}

Bytes Deflater::zlib_stream(int level, std::span<const std::byte> data) {
    const std::span<const std::byte> deflated =
        level <= kMaxIsalLevel ? deflate_fast(data, true) : deflate_whole(level, data);
    const std::array<std::byte, 4> check = big_endian(adler32_of(data));
    Bytes stream(kZlibHeader.size() + deflated.size() + check.size());
    const auto blocks = std::ranges::copy(kZlibHeader, stream.begin()).out;
    const auto end = std::ranges::copy(deflated, blocks).out;
    std::ranges::copy(check, end);
    return stream;
}

void Deflater::reserve_output(std::size_t size) {
    if (deflated_.size() < size) {
        deflated_.resize(size);
    }
}

std::uint32_t adler32_of(std::span<const std::byte> data) {
    return isal_adler32(1, input_of(data), data.size());
}

std::uint32_t joined_adler32(std::uint32_t first, std::uint32_t second, std::size_t second_size) {
    return static_cast<std::uint32_t>(
        adler32_combine(first, second, static_cast<z_off_t>(second_size)));
}

}  // namespace foam::texgen
