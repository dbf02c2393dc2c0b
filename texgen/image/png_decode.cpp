// SPDX-License-Identifier: Apache-2.0

#include "core/files/input_limits.h"
#include "texgen/image/memory.h"
#include "texgen/image/png.h"
#include "texgen/image/png_chunk.h"
#include "texgen/image/png_session.h"

#include <fmt/core.h>

#include <bit>

namespace foam::texgen {

namespace {

/// The part of the stream that has not been read yet.
using Source = std::span<const std::byte>;

// The largest compression ratio of deflate. A stream is rejected, before its pixels are allocated,
// if an image of the size in its header would need a larger ratio.
constexpr std::size_t kMaxCompressionRatio = 1032;

/// The read callback of libpng: copies the next `count` bytes of the source to `data`.
void read_callback(png_structp png, png_bytep data, std::size_t count) {
    auto& source = *static_cast<Source*>(png_get_io_ptr(png));
    if (count > source.size()) {
        png_error(png, "unexpected end of the data");
    }
    std::memcpy(data, source.data(), count);
    source = source.subspan(count);
}

/// Reports an error to libpng if the rest of the stream, which has `left` bytes, is too short for
/// an image of the size in the header.
void check_stream_length(const PngSession& session, std::size_t left) {
    const std::size_t promised = png_get_rowbytes(session.png(), session.info()) *
                                 png_get_image_height(session.png(), session.info());
    if (promised / kMaxCompressionRatio > left) {
        png_error(session.png(), "the data is too short for an image of this size");
    }
}

/// Throws InputError if a chunk is longer than the rest of the file. libpng allocates memory for a
/// chunk before it reads the chunk. Without this check, a short file could therefore make libpng
/// allocate 2 GiB. Bytes after the last chunk, IEND, are ignored. Files that are no PNG pass this
/// check; libpng rejects them later.
void check_chunk_lengths(std::span<const std::byte> file) {
    std::optional<std::span<const std::byte>> rest = after_png_signature(file);
    while (rest && !rest->empty()) {
        const std::optional<PngChunk> chunk = take_png_chunk(*rest);
        if (!chunk) {
            throw InputError("malformed PNG: unexpected end of the data");
        }
        if (chunk->type == "IEND") {
            return;
        }
    }
}

/// Makes libpng return 1 to 4 channels of samples of type Sample in the layout of an Image.
/// Precondition: Sample has at least as many bits as the samples of the file.
template <class Sample>
void request_samples(const PngSession& session) {
    png_structp png = session.png();
    png_set_expand(png);
    if (sizeof(Sample) == 2) {
        png_set_expand_16(png);
        if (std::endian::native == std::endian::little) {
            png_set_swap(png);
        }
    }
    png_set_interlace_handling(png);
    png_read_update_info(png, session.info());
}

/// Reads all chunks that precede the pixels.
void read_header(const PngSession& session, Source& source) {
    png_set_read_fn(session.png(), &source, read_callback);
    png_read_info(session.png(), session.info());
    check_stream_length(session, source.size());
}

/// Throws InputError if an image is too large, and OutOfMemory if the machine has too little memory
/// for it. Precondition: `request_samples` has been run.
void check_image_size(const PngSession& session) {
    const std::uint64_t width = png_get_image_width(session.png(), session.info());
    const std::uint64_t height = png_get_image_height(session.png(), session.info());
    if (width * height > static_cast<std::uint64_t>(kMaxImagePixels)) {
        throw InputError(
            fmt::format("an image of {} x {} pixels is too large: at most {} pixels are supported",
                        width,
                        height,
                        kMaxImagePixels));
    }
    require_memory(png_get_rowbytes(session.png(), session.info()) * height,
                   fmt::format("an image of {} x {} pixels", width, height));
}

template <class Sample>
Image<Sample> blank_image(const PngSession& session) {
    return {static_cast<int>(png_get_image_width(session.png(), session.info())),
            static_cast<int>(png_get_image_height(session.png(), session.info())),
            png_get_channels(session.png(), session.info())};
}

/// Returns pointers to the rows of a view in libpng's order, the top row first.
template <class Sample>
std::vector<png_bytep> rows_from_top(ImageView<Sample> view) {
    std::vector<png_bytep> rows;
    for (int y = view.height() - 1; y >= 0; --y) {
        rows.push_back(reinterpret_cast<png_bytep>(view.row(y).data()));
    }
    return rows;
}

std::string latin1_to_utf8(std::string_view text) {
    std::string utf8;
    for (const char c : text) {
        const auto code = static_cast<unsigned char>(c);
        if (code < 0x80) {
            utf8 += c;
        } else {
            utf8 += static_cast<char>(0xc0 | (code >> 6));
            utf8 += static_cast<char>(0x80 | (code & 0x3f));
        }
    }
    return utf8;
}

std::string utf8_text(const png_text& chunk) {
    const bool international = chunk.compression >= PNG_ITXT_COMPRESSION_NONE;
    return international ? std::string(chunk.text, chunk.itxt_length)
                         : latin1_to_utf8({chunk.text, chunk.text_length});
}

ImageMetadata metadata_of(const PngSession& session) {
    ImageMetadata metadata;
    metadata.color = png_get_valid(session.png(), session.info(), PNG_INFO_sRGB) != 0;
    png_textp chunks = nullptr;
    int count = 0;
    png_get_text(session.png(), session.info(), &chunks, &count);
    for (const png_text& chunk : std::span(chunks, static_cast<std::size_t>(count))) {
        metadata.text.emplace_back(chunk.key, utf8_text(chunk));
    }
    return metadata;
}

void check_decoded(const PngSession& session, bool succeeded) {
    if (!succeeded) {
        throw InputError(fmt::format("malformed PNG: {}", session.error()));
    }
}

/// Reads the pixels and all chunks that follow them.
template <class Sample>
Picture decode_pixels(PngSession& session) {
    check_decoded(session, session.run([&] { request_samples<Sample>(session); }));
    check_image_size(session);
    Image<Sample> pixels = blank_image<Sample>(session);
    std::vector<png_bytep> rows = rows_from_top(pixels.view());
    check_decoded(session, session.run([&] {
        png_read_image(session.png(), rows.data());
        png_read_end(session.png(), session.info());
    }));
    return {{code_channels(std::move(pixels))}, metadata_of(session)};
}

}  // namespace

Picture decode_png(std::span<const std::byte> content) {
    check_chunk_lengths(content);
    Source source = content;
    PngSession session(PngDirection::Read);
    check_decoded(session, session.run([&] { read_header(session, source); }));
    const bool is_deep = png_get_bit_depth(session.png(), session.info()) > 8;
    return is_deep ? decode_pixels<std::uint16_t>(session) : decode_pixels<std::uint8_t>(session);
}

}  // namespace foam::texgen
