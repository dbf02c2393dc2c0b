// SPDX-License-Identifier: Apache-2.0

#include "texgen/image/apng.h"

#include <fmt/core.h>
#include <zlib.h>

#include <algorithm>
#include <array>
#include <limits>
#include <stdexcept>
#include <string_view>
#include <utility>
#include <vector>

// Joins encoded PNGs without decoding them. The stream begins with the signature of PNG and the
// chunks of the first frame that precede its pixel data. Then an acTL chunk gives the number of
// frames and how often the animation is played. Each frame consists of an fcTL chunk, which gives
// its width, height and duration, and of its pixel data. The pixel data of the first frame are IDAT
// chunks. The pixel data of later frames are fdAT chunks, each with a sequence number and the
// content of an IDAT chunk. All other chunks of later frames are dropped.

namespace foam::texgen {

namespace {

// The first bytes of every PNG.
constexpr std::array<unsigned char, 8> kSignature = {0x89, 'P', 'N', 'G', '\r', '\n', 0x1a, '\n'};
// The following sizes are in bytes.
constexpr std::size_t kWord = 4;           // the length, the type or the checksum of a chunk
constexpr std::size_t kSizeBytes = 8;      // width and height, at the start of an IHDR's content
constexpr std::size_t kFrameControl = 26;  // the content of an fcTL
// An acTL chunk with this number of plays requests an endless loop.
constexpr std::uint32_t kPlayForever = 0;

using Content = std::span<const std::byte>;

struct Chunk {
    std::string_view type;
    Content content;
};

[[noreturn]] void reject_stream() {
    throw std::invalid_argument("a frame is not a PNG stream");
}

/// Returns the big-endian number in the first 4 bytes. Precondition: there are at least 4 bytes.
std::uint32_t number_at(Content bytes) {
    std::uint32_t number = 0;
    for (const std::byte byte : bytes.first(kWord)) {
        number = number << 8 | std::to_integer<std::uint32_t>(byte);
    }
    return number;
}

void append(Bytes& to, Content bytes) {
    to.insert(to.end(), bytes.begin(), bytes.end());
}

/// Appends a number in big-endian byte order.
template <class Number>
void append_number(Bytes& to, Number number) {
    for (int shift = 8 * static_cast<int>(sizeof(Number)) - 8; shift >= 0; shift -= 8) {
        to.push_back(static_cast<std::byte>(number >> shift));
    }
}

/// Appends a chunk: the length of its content, its type, its content, and the CRC of type and
/// content (section 5.3 of the PNG specification).
void append_chunk(Bytes& to, std::string_view type, Content content) {
    append_number(to, static_cast<std::uint32_t>(content.size()));
    const std::size_t begin = to.size();
    append(to, std::as_bytes(std::span(type)));
    append(to, content);
    const auto* checked = reinterpret_cast<const Bytef*>(to.data() + begin);
    append_number(to, static_cast<std::uint32_t>(crc32_z(0, checked, to.size() - begin)));
}

/// Returns the stream without its signature. Throws std::invalid_argument if the stream does not
/// begin with the signature of PNG.
Content after_signature(Content png) {
    const Content signature = std::as_bytes(std::span(kSignature));
    if (png.size() < signature.size() ||
        !std::equal(signature.begin(), signature.end(), png.begin())) {
        reject_stream();
    }
    return png.subspan(signature.size());
}

/// Removes the first chunk from a stream and returns it. Throws std::invalid_argument if the chunk
/// is incomplete.
Chunk take_chunk(Content& rest) {
    if (rest.size() < 3 * kWord || rest.size() - 3 * kWord < number_at(rest)) {
        reject_stream();
    }
    const std::size_t size = number_at(rest);
    const auto* type = reinterpret_cast<const char*>(rest.data() + kWord);
    const Chunk chunk{{type, kWord}, rest.subspan(2 * kWord, size)};
    rest = rest.subspan(3 * kWord + size);
    return chunk;
}

/// Returns all chunks of a PNG. They refer to the bytes of `png`. Throws std::invalid_argument if
/// the signature is wrong, if a chunk is incomplete, if the first chunk is not IHDR or is shorter
/// than kSizeBytes, if no chunk is IDAT, or if the PNG has a palette.
std::vector<Chunk> chunks_of(Content png) {
    std::vector<Chunk> chunks;
    for (Content rest = after_signature(png); !rest.empty();) {
        chunks.push_back(take_chunk(rest));
    }
    const bool has_data = std::ranges::find(chunks, "IDAT", &Chunk::type) != chunks.end();
    if (!has_data || chunks.front().type != "IHDR" || chunks.front().content.size() < kSizeBytes) {
        reject_stream();
    }
    if (std::ranges::find(chunks, "PLTE", &Chunk::type) != chunks.end()) {
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
    const Content signature = std::as_bytes(std::span(kSignature));
    stream_.assign(signature.begin(), signature.end());
}

void ApngMuxer::add(Content png) {
    if (added_ == frames_) {
        throw std::invalid_argument(
            fmt::format("the animation already has all of its {} frames", frames_));
    }
    const std::vector<Chunk> chunks = chunks_of(png);
    check_header(chunks.front().content);
    bool begun = false;
    for (const Chunk& chunk : chunks) {
        if (chunk.type == "IDAT") {
            if (!std::exchange(begun, true)) {
                append_frame();
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
        throw std::invalid_argument("a frame has a different size or color type than the first");
    }
}

void ApngMuxer::append_animation() {
    Bytes control;
    append_number(control, static_cast<std::uint32_t>(frames_));
    append_number(control, kPlayForever);
    append_chunk(stream_, "acTL", control);
}

void ApngMuxer::append_frame() {
    if (added_ == 0) {
        append_animation();
    }
    Bytes control;
    control.reserve(kFrameControl);
    append_number(control, sequence_++);
    append(control, Content(header_).first(kSizeBytes));
    append_number(control, std::uint64_t{0});  // offset of the frame in x and y
    append_number(control, static_cast<std::uint16_t>(rate_.seconds));
    append_number(control, static_cast<std::uint16_t>(rate_.frames));
    append_number(control, std::uint16_t{0});  // dispose_op none, blend_op source: replace pixels
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
    numbered.reserve(kWord + data.size());
    append_number(numbered, sequence_++);
    append(numbered, data);
    append_chunk(stream_, "fdAT", numbered);
}

}  // namespace foam::texgen
