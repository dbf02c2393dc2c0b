// SPDX-License-Identifier: Apache-2.0

#include "texgen/image/exr_header.h"

#include "core/files/input_limits.h"
#include "texgen/image/exr_stream.h"
#include "texgen/image/memory.h"

#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfTileDescription.h>
#include <OpenEXR/ImfVersion.h>
#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <string_view>

namespace foam::texgen {

namespace {

constexpr std::size_t kPreamble = 8;  // bytes: the magic number and the version
constexpr std::uint32_t kExrMagic = 20000630;
// An EXR contains a table with the position of each block. A block is a tile, or the rows that are
// compressed together. This is the number of bytes of a position.
constexpr double kBytesOfOffset = 8.0;
// The largest allowed size of a decoded block, in bytes. If the decoded image is larger, a block
// may be as large as the image.
constexpr double kMaxBlock = 64.0 * 1024 * 1024;
// The largest compression ratio of deflate. The other methods of EXR, except DWA, compress samples
// of 16 bits by at most this ratio, too. All samples are counted as samples of 16 bits, so longer
// ones need no other ratio.
constexpr double kMaxDeflateRatio = 1032.0;
// The largest compression ratio of DWA, a lossy method of EXR. Before it uses deflate, DWA reduces
// each square of 8 x 8 samples, in the extreme case to a single number.
constexpr double kMaxDwaRatio = 64.0 * kMaxDeflateRatio;

/// A type of attributes whose values all have the same size in bytes.
struct TypeSize {
    std::string_view type;
    std::size_t size;
};
constexpr std::array<TypeSize, 23> kTypeSizes = {
    {{"box2i", 16},      {"box2f", 16},   {"chromaticities", 32},
     {"compression", 1}, {"double", 8},   {"envmap", 1},
     {"float", 4},       {"int", 4},      {"keycode", 28},
     {"lineOrder", 1},   {"m33f", 36},    {"m33d", 72},
     {"m44f", 64},       {"m44d", 128},   {"rational", 8},
     {"tiledesc", 9},    {"timecode", 8}, {"v2i", 8},
     {"v2f", 8},         {"v2d", 16},     {"v3i", 12},
     {"v3f", 12},        {"v3d", 24}}};

[[noreturn]] void reject(const std::string& reason) {
    throw InputError(reason);
}

/// Checks the lengths of the attributes of a header in the order in which OpenEXR will read them.
class AttributeScan {
  public:
    explicit AttributeScan(std::span<const std::byte> content) : rest_(content) {}

    /// Checks all attributes.
    void check() {
        take(kPreamble);
        while (!take_text().empty()) {
            const std::string_view type = take_text();
            check_value(type, take(take_size()));
        }
    }

  private:
    std::span<const std::byte> take(std::size_t size) {
        if (size > rest_.size()) {
            reject("unexpected end of the header");
        }
        const auto taken = rest_.first(size);
        rest_ = rest_.subspan(size);
        return taken;
    }

    std::uint32_t take_size() {
        std::uint32_t size = 0;
        std::memcpy(&size, take(sizeof(size)).data(), sizeof(size));
        return size;
    }

    // Reads a text that ends with a zero.
    std::string_view take_text() {
        const auto zero = std::ranges::find(rest_, std::byte{0});
        const auto length = static_cast<std::size_t>(zero - rest_.begin());
        const auto text = take(length + 1);
        return {reinterpret_cast<const char*>(text.data()), length};
    }

    static void check_value(std::string_view type, std::span<const std::byte> value) {
        const auto* const fixed = std::ranges::find(kTypeSizes, type, &TypeSize::type);
        if (fixed != kTypeSizes.end() && value.size() != fixed->size) {
            reject(fmt::format("an attribute of type {} must have {} bytes, not {}",
                               type,
                               fixed->size,
                               value.size()));
        }
        AttributeScan scan(value);
        if (type == "chlist") {
            scan.check_channels();
        } else if (type == "stringvector") {
            scan.check_texts();
        } else if (type == "preview") {
            const std::uint64_t width = scan.take_size();
            const std::uint64_t height = scan.take_size();
            constexpr std::uint64_t kMaxSide = 1U << 15U;
            if (width > kMaxSide || height > kMaxSide || 4 * width * height != scan.rest_.size()) {
                reject("the preview has an impossible size");
            }
        }
    }

    void check_channels() {
        constexpr std::size_t kChannel = 16;  // bytes after the name
        while (!take_text().empty()) {
            take(kChannel);
        }
        check_end("channels");
    }

    void check_texts() {
        while (!rest_.empty()) {
            take(take_size());
        }
    }

    void check_end(const char* what) const {
        if (!rest_.empty()) {
            reject(fmt::format("the list of {} has an impossible size", what));
        }
    }

    std::span<const std::byte> rest_;
};

Imf::Header read_header(std::span<const std::byte> content) {
    std::array<std::uint32_t, 2> preamble{};
    if (content.size() < kPreamble) {
        reject("unexpected end of the header");
    }
    std::memcpy(preamble.data(), content.data(), kPreamble);
    auto version = static_cast<int>(preamble[1]);
    if (preamble[0] != kExrMagic || Imf::getVersion(version) != Imf::EXR_VERSION) {
        reject("not an EXR of version 2");
    }
    if (Imf::isMultiPart(version) || Imf::isNonImage(version)) {
        reject("multi-part files and deep pixels are not supported");
    }
    AttributeScan(content).check();
    ExrInput stream(content);
    stream.seekg(kPreamble);
    Imf::Header header;
    header.readFrom(stream, version);
    header.sanityCheck(Imf::isTiled(version));
    return header;
}

double max_ratio(Imf::Compression compression) {
    const bool is_dwa =
        compression == Imf::DWAA_COMPRESSION || compression == Imf::DWAB_COMPRESSION;
    return is_dwa ? kMaxDwaRatio : kMaxDeflateRatio;
}

/// Returns the number of rows that the compression method compresses together.
int rows_of_block(Imf::Compression compression) {
    switch (compression) {
        case Imf::ZIP_COMPRESSION:
        case Imf::PXR24_COMPRESSION:
            return 16;
        case Imf::PIZ_COMPRESSION:
        case Imf::B44_COMPRESSION:
        case Imf::B44A_COMPRESSION:
        case Imf::DWAA_COMPRESSION:
            return 32;
        case Imf::DWAB_COMPRESSION:
            return 256;
        default:
            return 1;
    }
}

/// Returns the number of channels. Throws InputError if there is none, or if one is subsampled.
std::size_t count_channels(const Imf::Header& header) {
    std::size_t channels = 0;
    for (auto channel = header.channels().begin(); channel != header.channels().end(); ++channel) {
        ++channels;
        if (channel.channel().xSampling != 1 || channel.channel().ySampling != 1) {
            reject(
                fmt::format("channel '{}' is subsampled, which is not supported", channel.name()));
        }
    }
    if (channels == 0) {
        reject("the file has no channels");
    }
    return channels;
}

/// The width and height of an image or of a block.
struct Size {
    std::int64_t width;
    std::int64_t height;

    double area() const { return static_cast<double>(width) * static_cast<double>(height); }
};

Size block_of(const Imf::Header& header, const Size& image) {
    if (header.hasTileDescription()) {
        return {header.tileDescription().xSize, header.tileDescription().ySize};
    }
    return {image.width, rows_of_block(header.compression())};
}

}  // namespace

void check_exr_header(std::span<const std::byte> content) {
    const Imf::Header header = read_header(content);
    const Imath::Box2i& window = header.dataWindow();
    const Size image{std::int64_t{window.max.x} - window.min.x + 1,
                     std::int64_t{window.max.y} - window.min.y + 1};
    if (std::max(image.width, image.height) > kMaxImageExtent ||
        image.area() > static_cast<double>(kMaxImagePixels)) {
        reject(
            fmt::format("an image of {} x {} pixels is too large: at most {} pixels per side "
                        "and {} pixels are supported",
                        image.width,
                        image.height,
                        kMaxImageExtent,
                        kMaxImagePixels));
    }
    const auto channels = static_cast<double>(count_channels(header));
    const auto bytes = static_cast<double>(content.size());
    const Size block = block_of(header, image);
    if (block.width < 1 || block.height < 1) {
        reject("a tile or a block of rows has no pixels");
    }
    const std::int64_t columns = (image.width + block.width - 1) / block.width;
    const std::int64_t rows = (image.height + block.height - 1) / block.height;
    // The smallest samples, half floats, have 2 bytes.
    if (2.0 * channels * image.area() > bytes * max_ratio(header.compression()) ||
        static_cast<double>(columns * rows) * kBytesOfOffset > bytes) {
        reject("the data is too short for an image of this size");
    }
    const double decoded = sizeof(float) * channels * image.area();
    if (sizeof(float) * channels * block.area() > std::max(kMaxBlock, decoded)) {
        reject("the blocks of rows or the tiles are too large");
    }
    require_memory(static_cast<std::uint64_t>(decoded),
                   fmt::format("an image of {} x {} pixels", image.width, image.height));
}

}  // namespace foam::texgen
