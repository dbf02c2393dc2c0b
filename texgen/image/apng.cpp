// SPDX-License-Identifier: Apache-2.0

#include "texgen/image/apng.h"

#include "texgen/image/byte_order.h"
#include "texgen/image/png_chunk.h"

#include <fmt/core.h>
#include <zlib.h>

#include <algorithm>
#include <limits>
#include <optional>
#include <stdexcept>
#include <string_view>
#include <utility>
#include <vector>

// Joins encoded PNGs without decoding them. The stream begins with the signature of PNG and the
// chunks of the first frame that precede its pixel data. Then an acTL chunk gives the number of
// frames and how often the animation is played. Each frame consists of an fcTL chunk, which gives
// its width, height and duration, and of its pixel data. The pixel data of the first frame are IDAT
// chunks. The pixel data of later frames are fdAT chunks, each with a sequence number and the
// content of an IDAT chunk. All other chunks of the first frame keep their positions; those of
// later frames are dropped.

namespace foam::texgen {

namespace {

// The following sizes are in bytes.
constexpr std::size_t kSequenceNumber = 4;  // at the start of an fdAT's content
constexpr std::size_t kSizeBytes = 8;       // width and height, at the start of an IHDR's content
constexpr std::size_t kFrameControl = 26;   // the content of an fcTL
// An acTL chunk with this number of plays requests an endless loop.
constexpr std::uint32_t kPlayForever = 0;

using Content = std::span<const std::byte>;

[[noreturn]] void reject_stream() {
    throw std::invalid_argument("a frame is not a PNG stream");
}

/// Appends a chunk: the length of its content, its type, its content, and the CRC of type and
/// content (section 5.3 of the PNG specification).
void append_chunk(Bytes& to, std::string_view type, Content content) {
    append(to, big_endian(static_cast<std::uint32_t>(content.size())));
    const std::size_t begin = to.size();
    append(to, std::as_bytes(std::span(type)));
    append(to, content);
    const auto* checked = reinterpret_cast<const Bytef*>(to.data() + begin);
    append(to, big_endian(static_cast<std::uint32_t>(crc32_z(0, checked, to.size() - begin))));
}

/// Returns all chunks of a PNG. They refer to the bytes of `png`. Throws std::invalid_argument if
/// the signature is wrong, if a chunk is incomplete, if no chunk is IDAT, or if the PNG has a
/// palette. Also throws it if the first chunk is not IHDR or is shorter than kSizeBytes.
std::vector<PngChunk> chunks_of(Content png) {
    std::optional<Content> rest = after_png_signature(png);
    std::vector<PngChunk> chunks;
    while (rest && !rest->empty()) {
        const std::optional<PngChunk> chunk = take_png_chunk(*rest);
        if (!chunk) {
            reject_stream();
        }
        chunks.push_back(*chunk);
    }
    const bool has_data = std::ranges::find(chunks, "IDAT", &PngChunk::type) != chunks.end();
    if (!has_data || chunks.front().type != "IHDR" || chunks.front().content.size() < kSizeBytes) {
        reject_stream();
    }
    if (std::ranges::find(chunks, "PLTE", &PngChunk::type) != chunks.end()) {
        throw std::invalid_argument(
            "a frame has a palette, which is not supported in an animation");
    }
    return chunks;
}

/// Returns true if an fcTL chunk can store the number as the numerator or denominator of a
/// duration.
bool is_positive_uint16(int number) {
    return number >= 1 && number <= std::numeric_limits<std::uint16_t>::max();
}

}  // namespace

ApngMuxer::ApngMuxer(int frames, FrameRate rate) : frames_(frames), rate_(rate) {
    if (frames < 1 || !is_positive_uint16(rate.frames) || !is_positive_uint16(rate.seconds)) {
        throw std::invalid_argument(
            fmt::format("an animation needs at least one frame, and a frame rate whose numerator "
                        "and denominator are from 1 to 65535, not {} frames at {}/{}",
                        frames,
                        rate.frames,
                        rate.seconds));
    }
    const Content signature = std::as_bytes(std::span(kPngSignature));
    stream_.assign(signature.begin(), signature.end());
}

void ApngMuxer::add(Content png) {
    if (added_ == frames_) {
        throw std::invalid_argument(
            fmt::format("the animation already has all of its {} frames", frames_));
    }
    const std::vector<PngChunk> chunks = chunks_of(png);
    check_header(chunks.front().content);
    bool begun = false;
    for (const PngChunk& chunk : chunks) {
        if (chunk.type == "IDAT") {
            if (!std::exchange(begun, true)) {
                append_frame_control();
            }
            append_data(chunk.content);
        } else if (added_ == 0 && chunk.type != "IEND") {
            append_chunk(stream_, chunk.type, chunk.content);
        }
    }
    ++added_;
}

Bytes ApngMuxer::finish() {
    if (added_ != frames_) {
        throw std::invalid_argument(
            fmt::format("the animation has only {} of {} frames", added_, frames_));
    }
    append_chunk(stream_, "IEND", {});
    return std::move(stream_);
}

void ApngMuxer::check_header(Content header) {
    if (added_ == 0) {
        header_.assign(header.begin(), header.end());
    } else if (!std::ranges::equal(header, header_)) {
        throw std::invalid_argument(
            "a frame has a different size, sample type or interlacing than the first");
    }
}

void ApngMuxer::append_animation_control() {
    Bytes control;
    append(control, big_endian(static_cast<std::uint32_t>(frames_)));
    append(control, big_endian(kPlayForever));
    append_chunk(stream_, "acTL", control);
}

void ApngMuxer::append_frame_control() {
    if (added_ == 0) {
        append_animation_control();
    }
    Bytes control;
    control.reserve(kFrameControl);
    append(control, big_endian(sequence_++));
    append(control, Content(header_).first(kSizeBytes));
    append(control, big_endian(std::uint64_t{0}));  // offset of the frame in x and y
    append(control, big_endian(static_cast<std::uint16_t>(rate_.seconds)));
    append(control, big_endian(static_cast<std::uint16_t>(rate_.frames)));
    // The bytes dispose_op (0: none) and blend_op (0: source). The frame replaces all pixels.
    append(control, big_endian(std::uint16_t{0}));
    append_chunk(stream_, "fcTL", control);
}

// The data of the first frame remain in IDAT chunks, so that the stream is also a valid PNG without
// animation.
void ApngMuxer::append_data(Content data) {
    if (added_ == 0) {
        append_chunk(stream_, "IDAT", data);
        return;
    }
    Bytes numbered;
    numbered.reserve(kSequenceNumber + data.size());
    append(numbered, big_endian(sequence_++));
    append(numbered, data);
    append_chunk(stream_, "fdAT", numbered);
}

}  // namespace foam::texgen
