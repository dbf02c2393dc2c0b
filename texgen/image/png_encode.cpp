#include "texgen/image/png.h"
#include "texgen/image/png_session.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <new>
#include <stdexcept>

namespace foam::texgen {

namespace {

/// The samples of a picture, of any depth, as libpng takes them.
struct Rows {
    const png_byte* bottom;
    std::size_t stride;  // bytes
    int width;
    int height;
    int channels;
    int bit_depth;

    const png_byte* from_top(int y) const {
        return bottom + static_cast<std::size_t>(height - 1 - y) * stride;
    }
};

template <class Sample>
Rows rows_of(ImageView<const Sample> view) {
    return {reinterpret_cast<const png_byte*>(view.data()),
            view.row_samples() * sizeof(Sample),
            view.width(),
            view.height(),
            view.channels(),
            8 * static_cast<int>(sizeof(Sample))};
}

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

int filter_flags(PngFilter filter) {
    constexpr std::array<int, 6> kFlags = {PNG_FILTER_NONE,
                                           PNG_FILTER_SUB,
                                           PNG_FILTER_UP,
                                           PNG_FILTER_AVG,
                                           PNG_FILTER_PAETH,
                                           PNG_ALL_FILTERS};
    return kFlags.at(static_cast<std::size_t>(filter));
}

int color_type(int channels) {
    constexpr std::array<int, 4> kTypes = {
        PNG_COLOR_TYPE_GRAY, PNG_COLOR_TYPE_GRAY_ALPHA, PNG_COLOR_TYPE_RGB, PNG_COLOR_TYPE_RGBA};
    return kTypes.at(static_cast<std::size_t>(channels - 1));
}

void write_header(png_structp png, png_infop info, const Rows& rows, bool color) {
    png_set_IHDR(png,
                 info,
                 static_cast<png_uint_32>(rows.width),
                 static_cast<png_uint_32>(rows.height),
                 rows.bit_depth,
                 color_type(rows.channels),
                 PNG_INTERLACE_NONE,
                 PNG_COMPRESSION_TYPE_BASE,
                 PNG_FILTER_TYPE_BASE);
    if (color) {
        png_set_sRGB_gAMA_and_cHRM(png, info, PNG_sRGB_INTENT_PERCEPTUAL);
    }
}

void write_rows(png_structp png, png_infop info, const Rows& rows) {
    png_write_info(png, info);
    for (int y = 0; y < rows.height; ++y) {
        png_write_row(png, rows.from_top(y));
    }
    png_write_end(png, info);
}

Bytes encode(const Rows& rows, const PngMetadata& metadata, const PngEncoding& encoding) {
    const std::vector<png_text> texts = text_chunks(metadata);
    const int flags = filter_flags(encoding.filter);
    Bytes stream;
    PngSession session(PngDirection::Write);
    const bool written = session.run([&] {
        png_structp png = session.png();
        png_set_write_fn(png, &stream, append, nullptr);
        png_set_filter(png, PNG_FILTER_TYPE_BASE, flags);
        png_set_compression_level(png, encoding.compression_level);
        write_header(png, session.info(), rows, metadata.color);
        png_set_text(png, session.info(), texts.data(), static_cast<int>(texts.size()));
        write_rows(png, session.info(), rows);
    });
    if (!written) {
        throw OutputError(fmt::format("cannot encode a PNG: {}", session.error()));
    }
    return stream;
}

void check_encodable(ImageView<const std::uint8_t> pixels) {
    if (pixels.width() < 1 || pixels.height() < 1) {
        throw std::invalid_argument("a PNG needs at least one pixel");
    }
    if (pixels.channels() < 1 || pixels.channels() > 4) {
        throw std::invalid_argument(
            fmt::format("a PNG has 1 to 4 channels, not {}", pixels.channels()));
    }
}

}  // namespace

Bytes encode_png(ImageView<const std::uint8_t> pixels,
                 const PngMetadata& metadata,
                 const PngEncoding& encoding) {
    check_encodable(pixels);
    return encode(rows_of(pixels), metadata, encoding);
}

void write_png(const std::filesystem::path& path,
               ImageView<const std::uint8_t> pixels,
               const PngMetadata& metadata,
               const PngEncoding& encoding) {
    Bytes stream;
    try {
        stream = encode_png(pixels, metadata, encoding);
    } catch (const OutputError& error) {
        throw OutputError(fmt::format("cannot write '{}': {}", path.string(), error.what()));
    }
    write_file(path, stream);
}

}  // namespace foam::texgen
