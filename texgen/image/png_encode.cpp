// SPDX-License-Identifier: Apache-2.0

#include "texgen/image/png.h"
#include "texgen/image/png_data.h"
#include "texgen/image/png_session.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <new>
#include <stdexcept>

namespace foam::texgen {

namespace {

/// The write callback of libpng: appends `count` bytes to the stream that png_get_io_ptr returns.
/// Exceptions must not propagate through libpng, so std::bad_alloc is converted to a libpng error.
/// png_error is called outside of the catch block, because it does not return but calls longjmp.
void write_callback(png_structp png, png_bytep data, std::size_t count) {
    auto& stream = *static_cast<Bytes*>(png_get_io_ptr(png));
    const auto* bytes = reinterpret_cast<const std::byte*>(data);
    bool fits = true;
    try {
        stream.insert(stream.end(), bytes, bytes + count);
    } catch (const std::bad_alloc&) {
        fits = false;
    }
    if (!fits) {
        png_error(png, "out of memory");
    }
}

bool is_printable_ascii(char c) {
    return c >= ' ' && c <= '~';
}

bool is_keyword(const std::string& key) {
    return !key.empty() && key.size() <= PNG_KEYWORD_MAX_LENGTH && key.front() != ' ' &&
           key.back() != ' ' && key.find("  ") == std::string::npos &&
           std::all_of(key.begin(), key.end(), is_printable_ascii);
}

/// Returns libpng's constant for the kind of chunk that stores a text. ASCII texts are stored as
/// tEXt (Latin-1), which every program can read. All other texts are stored as iTXt (UTF-8).
int text_kind(const std::string& text) {
    const bool ascii =
        std::all_of(text.begin(), text.end(), [](unsigned char c) { return c > 0 && c < 0x80; });
    return ascii ? PNG_TEXT_COMPRESSION_NONE : PNG_ITXT_COMPRESSION_NONE;
}

/// Returns the texts as structures of libpng, which refer to the strings of `metadata`. Throws
/// std::invalid_argument for a keyword that is not allowed (encode_png).
std::vector<png_text> text_chunks(const ImageMetadata& metadata) {
    std::vector<png_text> chunks;
    for (const auto& [key, text] : metadata.text) {
        if (!is_keyword(key)) {
            throw std::invalid_argument(fmt::format("'{}' is not a valid PNG keyword", key));
        }
        png_text chunk{};
        chunk.compression = text_kind(text);
        chunk.key = const_cast<png_charp>(key.c_str());  // libpng only reads it
        chunk.text = const_cast<png_charp>(text.c_str());
        chunks.push_back(chunk);
    }
    return chunks;
}

int color_type(const PngRows& rows) {
    constexpr std::array<int, 4> kTypes = {
        PNG_COLOR_TYPE_GRAY, PNG_COLOR_TYPE_GRAY_ALPHA, PNG_COLOR_TYPE_RGB, PNG_COLOR_TYPE_RGBA};
    return kTypes.at(static_cast<std::size_t>(rows.channels() - 1));
}

void set_header(png_structp png, png_infop info, const PngRows& rows, bool color) {
    png_set_IHDR(png,
                 info,
                 static_cast<png_uint_32>(rows.width()),
                 static_cast<png_uint_32>(rows.height()),
                 rows.bit_depth(),
                 color_type(rows),
                 PNG_INTERLACE_NONE,
                 PNG_COMPRESSION_TYPE_BASE,
                 PNG_FILTER_TYPE_BASE);
    if (color) {
        png_set_sRGB_gAMA_and_cHRM(png, info, PNG_sRGB_INTENT_PERCEPTUAL);
    }
}

void write_bytes(png_structp png, std::span<const std::byte> bytes) {
    png_write_chunk_data(png, reinterpret_cast<png_const_bytep>(bytes.data()), bytes.size());
}

void write_chunk(png_structp png, const PngData::Chunk& chunk) {
    constexpr std::array<png_byte, 5> kType = {'I', 'D', 'A', 'T', 0};
    const std::size_t size = chunk.begin.size() + chunk.middle.size() + chunk.end.size();
    png_write_chunk_start(png, kType.data(), static_cast<png_uint_32>(size));
    write_bytes(png, chunk.begin);
    write_bytes(png, chunk.middle);
    write_bytes(png, chunk.end);
    png_write_chunk_end(png);
}

void write_end(png_structp png) {
    constexpr std::array<png_byte, 5> kType = {'I', 'E', 'N', 'D', 0};
    png_write_chunk(png, kType.data(), nullptr, 0);
}

void check_encoded(const PngSession& session, bool succeeded) {
    if (!succeeded) {
        throw OutputError(fmt::format("cannot encode a PNG: {}", session.error()));
    }
}

Bytes encode(const PngRows& rows, const ImageMetadata& metadata, const PngEncoding& encoding) {
    std::vector<png_text> texts = text_chunks(metadata);
    PngData data(rows, encoding);
    Bytes stream;
    PngSession session(PngDirection::Write);
    png_structp png = session.png();
    check_encoded(session, session.run([&] {
        png_set_write_fn(png, &stream, write_callback, nullptr);
        set_header(png, session.info(), rows, metadata.color);
        png_set_text(png, session.info(), texts.data(), static_cast<int>(texts.size()));
        png_write_info(png, session.info());
    }));
    while (!data.complete()) {
        const std::span<const PngData::Chunk> chunks = data.next_chunks();
        check_encoded(session, session.run([&] {
            for (const PngData::Chunk& chunk : chunks) {
                write_chunk(png, chunk);
            }
        }));
    }
    check_encoded(session, session.run([&] { write_end(png); }));
    return stream;
}

template <class Sample>
void check_encodable(ImageView<const Sample> pixels) {
    if (pixels.width() < 1 || pixels.height() < 1) {
        throw std::invalid_argument("a PNG needs at least one pixel");
    }
    if (pixels.channels() < 1 || pixels.channels() > 4) {
        throw std::invalid_argument(
            fmt::format("a PNG must have 1 to 4 channels, not {}", pixels.channels()));
    }
}

template <class Sample>
Bytes encode_checked(ImageView<const Sample> pixels,
                     const ImageMetadata& metadata,
                     const PngEncoding& encoding) {
    check_encodable(pixels);
    return encode(PngRows(pixels), metadata, encoding);
}

template <class Sample>
void encode_and_write(const std::filesystem::path& path,
                      ImageView<const Sample> pixels,
                      const ImageMetadata& metadata,
                      const PngEncoding& encoding) {
    Bytes stream;
    try {
        stream = encode_checked(pixels, metadata, encoding);
    } catch (const OutputError& error) {
        throw OutputError(fmt::format("cannot write '{}': {}", path.string(), error.what()));
    }
    write_file(path, stream);
}

}  // namespace

Bytes encode_png(ImageView<const std::uint8_t> pixels,
                 const ImageMetadata& metadata,
                 const PngEncoding& encoding) {
    return encode_checked(pixels, metadata, encoding);
}

Bytes encode_png(ImageView<const std::uint16_t> pixels,
                 const ImageMetadata& metadata,
                 const PngEncoding& encoding) {
    return encode_checked(pixels, metadata, encoding);
}

Bytes encode_png(const Picture& picture, const PngEncoding& encoding) {
    if (picture.groups.size() != 1 || !picture.groups.front().has_codes()) {
        throw std::invalid_argument("a PNG must have one group of 8-bit or 16-bit codes");
    }
    const ChannelGroup& group = picture.groups.front();
    if (const auto* bytes = std::get_if<Image<std::uint8_t>>(&group.samples)) {
        return encode_checked(bytes->view(), picture.metadata, encoding);
    }
    return encode_checked(
        std::get<Image<std::uint16_t>>(group.samples).view(), picture.metadata, encoding);
}

void write_png(const std::filesystem::path& path,
               ImageView<const std::uint8_t> pixels,
               const ImageMetadata& metadata,
               const PngEncoding& encoding) {
    encode_and_write(path, pixels, metadata, encoding);
}

void write_png(const std::filesystem::path& path,
               ImageView<const std::uint16_t> pixels,
               const ImageMetadata& metadata,
               const PngEncoding& encoding) {
    encode_and_write(path, pixels, metadata, encoding);
}

}  // namespace foam::texgen
