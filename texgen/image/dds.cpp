// SPDX-License-Identifier: Apache-2.0

#include "texgen/image/dds.h"

#include "texgen/image/byte_reader.h"
#include "texgen/image/texture_limits.h"

#include <fmt/core.h>

#include <array>
#include <cstdint>

// The file format is described in Microsoft's "Programming Guide for DDS" and in the references of
// DDS_HEADER and DDS_HEADER_DXT10. A file has a magic number, a header of 31 numbers and a second
// header of 5 numbers. Then the mip levels of each layer follow, the full size first.

namespace foam::texgen {

namespace {

constexpr std::uint32_t kDdsMagic = 0x20534444;  // "DDS "
constexpr std::uint32_t kDdsHeaderBytes = 124;
constexpr std::uint32_t kFormatBytes = 32;   // size of DDS_PIXELFORMAT in the first header
constexpr std::uint32_t kFourCc = 0x4;       // flag of DDS_PIXELFORMAT: the field dwFourCC is used
constexpr std::uint32_t kDx10 = 0x30315844;  // "DX10" in dwFourCC: there is a second header

// Flags of the first header. Each flag states that certain fields of the header are used.
constexpr std::uint32_t kAlways = 0x1007;       // caps, height, width and the pixel format
constexpr std::uint32_t kMipLevels = 0x20000;   // the number of mip levels
constexpr std::uint32_t kRowBytes = 0x8;        // the bytes of a row
constexpr std::uint32_t kImageBytes = 0x80000;  // the bytes of the largest level

// Bits of the field dwCaps, for every texture and for a texture with mip levels.
constexpr std::uint32_t kTexture = 0x1000;
constexpr std::uint32_t kHasMipLevels = 0x400008;

constexpr std::uint32_t kTwoDimensional = 3;
constexpr std::uint32_t kCube = 0x4;

// The last number of the second header contains the alpha mode in the bits kAlphaMode. The
// constants after kAlphaMode are values of the alpha mode.
constexpr std::uint32_t kAlphaMode = 0x7;
constexpr std::uint32_t kStraightAlpha = 1;
constexpr std::uint32_t kPremultipliedAlpha = 2;
constexpr std::uint32_t kOpaque = 3;

void check_dds(bool holds, const char* reason) {
    if (!holds) {
        throw InputError(fmt::format("malformed DDS: {}", reason));
    }
}

// Returns the number of bytes of all mip levels of all layers together.
std::size_t level_bytes(const GpuTexture& texture) {
    std::size_t bytes = 0;
    for (const std::vector<Bytes>& layer : texture.layers) {
        for (const Bytes& level : layer) {
            bytes += level.size();
        }
    }
    return bytes;
}

}  // namespace

Bytes encode_dds(const GpuTexture& texture) {
    const PixelFormatFacts& facts = facts_of(texture.format);
    const auto width = static_cast<std::uint32_t>(texture.width);
    const auto levels = static_cast<std::uint32_t>(texture.levels());
    const auto row_bytes = static_cast<std::uint32_t>(facts.unit_bytes * width);
    const auto whole_bytes = static_cast<std::uint32_t>(texture.layers.front().front().size());
    const std::array<std::uint32_t, 32> header = {
        kDdsMagic,
        kDdsHeaderBytes,
        kAlways | (levels > 1 ? kMipLevels : 0) | (facts.is_compressed ? kImageBytes : kRowBytes),
        static_cast<std::uint32_t>(texture.height),
        width,
        facts.is_compressed ? whole_bytes : row_bytes,
        0,  // depth
        levels,
        0,
        0,
        0,
        0,
        0,
        0,
        0,
        0,
        0,
        0,
        0,  // reserved
        kFormatBytes,
        kFourCc,
        kDx10,
        0,
        0,
        0,
        0,
        0,  // bit masks, which the second header replaces
        kTexture | (levels > 1 ? kHasMipLevels : 0),
        0,
        0,
        0,
        0};
    const std::array<std::uint32_t, 5> second = {facts.dxgi,
                                                 kTwoDimensional,
                                                 0,
                                                 static_cast<std::uint32_t>(texture.layers.size()),
                                                 texture.opaque ? kOpaque : kStraightAlpha};
    Bytes bytes;
    bytes.reserve(sizeof(header) + sizeof(second) + level_bytes(texture));
    for (const std::uint32_t number : header) {
        append_number(bytes, number);
    }
    for (const std::uint32_t number : second) {
        append_number(bytes, number);
    }
    for (const std::vector<Bytes>& layer : texture.layers) {
        for (const Bytes& level : layer) {
            bytes.insert(bytes.end(), level.begin(), level.end());
        }
    }
    return bytes;
}

GpuTexture decode_dds(std::span<const std::byte> content) {
    ByteReader reader(content);
    check_dds(reader.number() == kDdsMagic, "the file does not begin with \"DDS \"");
    std::array<std::uint32_t, 31> header{};
    for (std::uint32_t& number : header) {
        number = reader.number();
    }
    check_dds(header[0] == kDdsHeaderBytes, "the header does not have 124 bytes");
    if (header[20] != kDx10) {
        throw InputError("the DDS has no header of Direct3D 10 (DX10), which foamtex needs");
    }
    const std::uint32_t number = reader.number();
    const std::optional<PixelFormat> format = find_dxgi_format(number);
    if (!format) {
        throw InputError(
            fmt::format("the DDS has the pixel format {}, which foamtex does not read", number));
    }
    check_supported("DDS", reader.number() == kTwoDimensional, "is not two-dimensional");
    check_supported("DDS", (reader.number() & kCube) == 0, "is a cube");
    const std::uint32_t layers = reader.number();
    const std::uint32_t alpha = reader.number() & kAlphaMode;
    check_supported("DDS", alpha != kPremultipliedAlpha, "has premultiplied alpha");
    const std::uint32_t levels = std::max(header[6], 1U);
    check_texture_size("DDS", header[3], header[2], levels, layers);
    require_texture_memory(
        reader.remaining(), static_cast<int>(header[3]), static_cast<int>(header[2]));
    GpuTexture texture{.format = *format,
                       .width = static_cast<int>(header[3]),
                       .height = static_cast<int>(header[2]),
                       .is_array = layers > 1,
                       .opaque = alpha == kOpaque,
                       .layers = std::vector<std::vector<Bytes>>(layers),
                       .text = {}};
    for (std::vector<Bytes>& layer : texture.layers) {
        for (int level = 0; level < static_cast<int>(levels); ++level) {
            const auto image = reader.take(image_bytes(
                *format, level_extent(texture.width, level), level_extent(texture.height, level)));
            layer.emplace_back(image.begin(), image.end());
        }
    }
    check_dds(reader.remaining() == 0, "the file is longer than its images");
    return texture;
}

}  // namespace foam::texgen
