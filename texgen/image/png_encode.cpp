#include "texgen/image/png.h"
#include "texgen/image/png_data.h"
#include "texgen/image/png_palette.h"
#include "texgen/image/png_session.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <new>
#include <optional>
#include <stdexcept>

namespace foam::texgen {

namespace {

void append(png_structp png, png_bytep data, std::size_t count) {
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

/// ASCII is the same in Latin-1 and UTF-8 and goes as tEXt, which every program reads; all else as
/// iTXt.
int text_kind(const std::string& text) {
    const bool ascii = std::all_of(text.begin(), text.end(), [](char c) { return c > 0; });
    return ascii ? PNG_TEXT_COMPRESSION_NONE : PNG_ITXT_COMPRESSION_NONE;
}

/// Borrows the strings.
std::vector<png_text> text_chunks(const PngMetadata& metadata) {
    std::vector<png_text> chunks;
    for (const auto& [key, text] : metadata.text) {
        if (!is_keyword(key)) {
            throw std::invalid_argument(fmt::format("'{}' is no PNG keyword", key));
        }
        png_text chunk{};
        chunk.compression = text_kind(text);
        chunk.key = const_cast<png_charp>(key.c_str());  // libpng copies and does not write
        chunk.text = const_cast<png_charp>(text.c_str());
        chunks.push_back(chunk);
    }
    return chunks;
}

int color_type(const PngRows& rows, const IndexedImage* indexed) {
    constexpr std::array<int, 4> kTypes = {
        PNG_COLOR_TYPE_GRAY, PNG_COLOR_TYPE_GRAY_ALPHA, PNG_COLOR_TYPE_RGB, PNG_COLOR_TYPE_RGBA};
    return indexed != nullptr ? PNG_COLOR_TYPE_PALETTE
                              : kTypes.at(static_cast<std::size_t>(rows.channels() - 1));
}

/// A picture as it goes into the file.
struct Content {
    explicit Content(PngRows picture) : rows(picture) {}
    Content(const IndexedImage& image, int channels)
        : rows(image.indices.view()), indexed(&image), has_alpha(channels == 4) {}

    PngRows rows;
    const IndexedImage* indexed = nullptr;  // whose indices the rows are
    bool has_alpha = false;                 // in the palette
};

void set_palette(png_structp png, png_infop info, const Content& content) {
    std::array<png_color, kMaxPalette> colors{};
    std::array<png_byte, kMaxPalette> opacities{};
    const auto count = static_cast<int>(content.indexed->palette.size());
    for (std::size_t k = 0; k < content.indexed->palette.size(); ++k) {
        const PaletteColor& color = content.indexed->palette[k];
        colors.at(k) = {color[0], color[1], color[2]};
        opacities.at(k) = color[3];
    }
    png_set_PLTE(png, info, colors.data(), count);
    if (content.has_alpha) {
        png_set_tRNS(png, info, opacities.data(), count, nullptr);
    }
}

void set_header(png_structp png, png_infop info, const Content& content, bool color) {
    png_set_IHDR(png,
                 info,
                 static_cast<png_uint_32>(content.rows.width()),
                 static_cast<png_uint_32>(content.rows.height()),
                 content.rows.bit_depth(),
                 color_type(content.rows, content.indexed),
                 PNG_INTERLACE_NONE,
                 PNG_COMPRESSION_TYPE_BASE,
                 PNG_FILTER_TYPE_BASE);
    if (content.indexed != nullptr) {
        set_palette(png, info, content);
    }
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

void check(const PngSession& session, bool survived) {
    if (!survived) {
        throw OutputError(fmt::format("cannot encode a PNG: {}", session.error()));
    }
}

void write_stream(const Content& content,
                  const PngMetadata& metadata,
                  PngData& data,
                  Bytes& stream) {
    std::vector<png_text> texts = text_chunks(metadata);
    PngSession session(PngDirection::Write);
    png_structp png = session.png();
    check(session, session.run([&] {
        png_set_write_fn(png, &stream, append, nullptr);
        set_header(png, session.info(), content, metadata.color);
        png_set_text(png, session.info(), texts.data(), static_cast<int>(texts.size()));
        png_write_info(png, session.info());
    }));
    while (!data.complete()) {
        const std::span<const PngData::Chunk> chunks = data.next_chunks();
        check(session, session.run([&] {
            for (const PngData::Chunk& chunk : chunks) {
                write_chunk(png, chunk);
            }
        }));
    }
    check(session, session.run([&] { write_end(png); }));
}

template <class Sample>
void check_encodable(ImageView<const Sample> pixels) {
    if (pixels.width() < 1 || pixels.height() < 1) {
        throw std::invalid_argument("a PNG needs at least one pixel");
    }
    if (pixels.channels() < 1 || pixels.channels() > 4) {
        throw std::invalid_argument(
            fmt::format("a PNG has 1 to 4 channels, not {}", pixels.channels()));
    }
}

template <class Sample>
Bytes encode_once(ImageView<const Sample> pixels,
                  const PngMetadata& metadata,
                  const PngEncoding& encoding) {
    PngEncoder encoder;
    const std::span<const std::byte> stream = encoder.encode(pixels, metadata, encoding);
    return {stream.begin(), stream.end()};
}

template <class Sample>
void write_once(const std::filesystem::path& path,
                ImageView<const Sample> pixels,
                const PngMetadata& metadata,
                const PngEncoding& encoding) {
    PngEncoder encoder;
    std::span<const std::byte> stream;
    try {
        stream = encoder.encode(pixels, metadata, encoding);
    } catch (const OutputError& error) {
        throw OutputError(fmt::format("cannot write '{}': {}", path.string(), error.what()));
    }
    write_file(path, stream);
}

}  // namespace

struct PngEncoder::Buffers {
    Bytes stream;
    std::vector<PngPart> parts;

    std::span<const std::byte> encode(const Content& content,
                                      const PngMetadata& metadata,
                                      const PngEncoding& encoding) {
        stream.clear();
        PngData data(content.rows, encoding, parts);
        write_stream(content, metadata, data, stream);
        return stream;
    }
};

PngEncoder::PngEncoder() : buffers_(std::make_unique<Buffers>()) {}
PngEncoder::~PngEncoder() = default;
PngEncoder::PngEncoder(PngEncoder&&) noexcept = default;
PngEncoder& PngEncoder::operator=(PngEncoder&&) noexcept = default;

std::span<const std::byte> PngEncoder::encode(ImageView<const std::uint8_t> pixels,
                                              const PngMetadata& metadata,
                                              const PngEncoding& encoding) {
    check_encodable(pixels);
    if (encoding.palette && pixels.channels() >= 3) {
        if (const std::optional<IndexedImage> indexed = with_palette(pixels)) {
            return buffers_->encode(Content(*indexed, pixels.channels()), metadata, encoding);
        }
    }
    return buffers_->encode(Content(PngRows(pixels)), metadata, encoding);
}

std::span<const std::byte> PngEncoder::encode(ImageView<const std::uint16_t> pixels,
                                              const PngMetadata& metadata,
                                              const PngEncoding& encoding) {
    check_encodable(pixels);
    return buffers_->encode(Content(PngRows(pixels)), metadata, encoding);
}

Bytes encode_png(ImageView<const std::uint8_t> pixels,
                 const PngMetadata& metadata,
                 const PngEncoding& encoding) {
    return encode_once(pixels, metadata, encoding);
}

Bytes encode_png(ImageView<const std::uint16_t> pixels,
                 const PngMetadata& metadata,
                 const PngEncoding& encoding) {
    return encode_once(pixels, metadata, encoding);
}

void write_png(const std::filesystem::path& path,
               ImageView<const std::uint8_t> pixels,
               const PngMetadata& metadata,
               const PngEncoding& encoding) {
    write_once(path, pixels, metadata, encoding);
}

void write_png(const std::filesystem::path& path,
               ImageView<const std::uint16_t> pixels,
               const PngMetadata& metadata,
               const PngEncoding& encoding) {
    write_once(path, pixels, metadata, encoding);
}

}  // namespace foam::texgen
