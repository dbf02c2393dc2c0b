// SPDX-License-Identifier: Apache-2.0

#include "texgen/image/gpu_texture.h"

#include "core/parallel/parallel_for.h"
#include "texgen/blocks/bc4.h"
#include "texgen/blocks/bc7.h"
#include "texgen/image/byte_reader.h"
#include "texgen/image/texture_limits.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cassert>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <stdexcept>
#include <type_traits>
#include <variant>

namespace foam::texgen {

namespace {

constexpr std::size_t kAlpha = 3;  // index of the fourth channel

// Copies texels of kFrom channels to texels of kTo channels. Missing channels are 0, except for
// alpha, which is 1.
template <std::size_t kFrom, std::size_t kTo, class Code>
void copy_texels(std::span<const Code> from, std::span<Code> to) {
    for (std::size_t k = 0; k < from.size() / kFrom; ++k) {
        for (std::size_t c = 0; c < kTo; ++c) {
            constexpr Code kOne = std::numeric_limits<Code>::max();
            to[kTo * k + c] = c < kFrom ? from[kFrom * k + c] : c == kAlpha ? kOne : Code{0};
        }
    }
}

// Copies texels from a picture to a pixel format or back. Precondition: the two numbers of channels
// are equal or are one of the pairs below.
template <class Code>
void copy_texels(std::span<const Code> from, int channels, std::span<Code> to, int to_channels) {
    if (channels == to_channels) {
        std::ranges::copy(from, to.begin());
    } else if (channels == 3 && to_channels == 4) {
        copy_texels<3, 4>(from, to);
    } else if (channels == 4 && to_channels == 3) {
        copy_texels<4, 3>(from, to);
    } else if (channels == 3 && to_channels == 2) {
        copy_texels<3, 2>(from, to);
    } else {
        assert(channels == 2 && to_channels == 3);
        copy_texels<2, 3>(from, to);
    }
}

// The integers of a texture are stored with the least significant byte first.
template <class Code>
void to_or_from_little_endian(std::span<Code> codes) {
    if constexpr (std::endian::native != std::endian::little) {
        for (Code& code : codes) {
            const auto bytes = little_endian(code);
            std::memcpy(&code, bytes.data(), sizeof(Code));
        }
    }
}

// Returns the bytes of an image in a format that is not compressed.
template <class Code>
Bytes plain_texels(const Image<Code>& pixels, int channels) {
    std::vector<Code> row(static_cast<std::size_t>(pixels.width()) *
                          static_cast<std::size_t>(channels));
    Bytes bytes(row.size() * sizeof(Code) * static_cast<std::size_t>(pixels.height()));
    std::byte* to = bytes.data();
    for (int y = pixels.height() - 1; y >= 0; --y) {
        copy_texels<Code>(pixels.row(y), pixels.channels(), row, channels);
        to_or_from_little_endian<Code>(row);
        std::memcpy(to, row.data(), row.size() * sizeof(Code));
        to += row.size() * sizeof(Code);
    }
    return bytes;
}

// Returns a block of a picture. Positions beyond the image have the sample of the nearest pixel.
// Missing channels are 0, except for alpha, which is 255. Rows are counted from the top.
template <std::size_t kChannels>
TexelBlock block_at(const Image<std::uint8_t>& pixels, int left, int top) {
    TexelBlock block{};
    for (int k = 0; k < kBlockTexels; ++k) {
        const int x = std::min(left + k % kBlockSide, pixels.width() - 1);
        const int y = std::min(top + k / kBlockSide, pixels.height() - 1);
        const std::uint8_t* const from = pixels.pixel(x, pixels.height() - 1 - y).data();
        std::array<std::uint8_t, 4>& texel = block[static_cast<std::size_t>(k)];
        texel[kAlpha] = 255;
        std::copy_n(from, kChannels, texel.begin());
    }
    return block;
}

TexelBlock block_at(const Image<std::uint8_t>& pixels, int left, int top) {
    switch (pixels.channels()) {
        case 1:
            return block_at<1>(pixels, left, top);
        case 3:
            return block_at<3>(pixels, left, top);
        default:
            return block_at<4>(pixels, left, top);
    }
}

template <std::size_t bytes>
using Encoder = void(std::span<const TexelBlock>, std::span<std::array<std::uint8_t, bytes>>);

template <std::size_t bytes>
Bytes compressed(const Image<std::uint8_t>& pixels, int threads, Encoder<bytes>* encode) {
    constexpr std::size_t kBlocksAtOnce = 1024;
    const int columns = (pixels.width() + kBlockSide - 1) / kBlockSide;
    const int rows = (pixels.height() + kBlockSide - 1) / kBlockSide;
    const auto count = static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows);
    Bytes result(count * bytes);
    parallel_for(count, kBlocksAtOnce, threads, [&](std::size_t first, std::size_t last) {
        std::vector<TexelBlock> texels;
        std::vector<std::array<std::uint8_t, bytes>> blocks(last - first);
        for (auto k = static_cast<int>(first); k < static_cast<int>(last); ++k) {
            texels.push_back(block_at(pixels, k % columns * kBlockSide, k / columns * kBlockSide));
        }
        encode(texels, blocks);
        std::memcpy(result.data() + first * bytes, blocks.data(), blocks.size() * bytes);
    });
    return result;
}

// Returns the bytes of a picture in a pixel format.
Bytes encode_image(const Picture& picture, PixelFormat format, int threads) {
    const ChannelGroup& group = picture.groups.front();
    if (group.type == SampleType::Uint16) {
        return plain_texels(std::get<Image<std::uint16_t>>(group.samples),
                            facts_of(format).channels);
    }
    const auto& pixels = std::get<Image<std::uint8_t>>(group.samples);
    switch (format) {
        case PixelFormat::Bc4:
            return compressed(pixels, threads, encode_bc4);
        case PixelFormat::Bc5:
            return compressed(pixels, threads, encode_bc5);
        case PixelFormat::Bc7:
        case PixelFormat::Bc7Srgb:
            return compressed(pixels, threads, encode_bc7);
        default:
            return plain_texels(pixels, facts_of(format).channels);
    }
}

// Returns the code of z, the third coordinate of a unit vector, given the codes of x and y. The
// coordinate z is not negative.
std::uint8_t z_of_normal(std::uint8_t x_code, std::uint8_t y_code) {
    const double x = x_code / 127.5 - 1.0;
    const double y = y_code / 127.5 - 1.0;
    const double z = std::sqrt(std::max(0.0, 1.0 - x * x - y * y));
    return static_cast<std::uint8_t>(z * 127.5 + 128.0);
}

TexelBlock decoded_block(PixelFormat format, std::span<const std::uint8_t> bytes) {
    if (format == PixelFormat::Bc4) {
        return decode_bc4(bytes.first<kBc4Bytes>());
    }
    if (format == PixelFormat::Bc5) {
        TexelBlock texels = decode_bc5(bytes.first<kBc5Bytes>());
        for (std::array<std::uint8_t, 4>& texel : texels) {
            texel[2] = z_of_normal(texel[0], texel[1]);
        }
        return texels;
    }
    return decode_bc7(bytes.first<kBc7Bytes>());
}

// Returns the number of channels of the picture that picture_of returns for a texture.
int picture_channels(const GpuTexture& texture) {
    const int channels = facts_of(texture.format).channels;
    return channels == 2 || (channels == 4 && texture.opaque) ? 3 : channels;
}

// Copies the texels of a block into the picture, except texels beyond the border of the picture.
// The top left texel of the block goes to column `left` and row `top`, counted from the top.
void copy_block(const TexelBlock& block, int left, int top, Image<std::uint8_t>& pixels) {
    for (int k = 0; k < kBlockTexels; ++k) {
        const int column = left + k % kBlockSide;
        const int row = pixels.height() - 1 - (top + k / kBlockSide);
        if (column < pixels.width() && row >= 0) {
            std::ranges::copy_n(block[static_cast<std::size_t>(k)].begin(),
                                pixels.channels(),
                                pixels.pixel(column, row).begin());
        }
    }
}

Image<std::uint8_t> decompressed(const GpuTexture& texture) {
    const Bytes& bytes = texture.layers.front().front();
    const std::size_t unit = facts_of(texture.format).unit_bytes;
    Image<std::uint8_t> pixels(texture.width, texture.height, picture_channels(texture));
    const auto* from = reinterpret_cast<const std::uint8_t*>(bytes.data());
    for (int y = 0; y < texture.height; y += kBlockSide) {
        for (int x = 0; x < texture.width; x += kBlockSide, from += unit) {
            copy_block(decoded_block(texture.format, {from, unit}), x, y, pixels);
        }
    }
    return pixels;
}

template <class Code>
Image<Code> plain_picture(const GpuTexture& texture) {
    const int stored = facts_of(texture.format).channels;
    Image<Code> pixels(texture.width, texture.height, picture_channels(texture));
    std::vector<Code> row(static_cast<std::size_t>(texture.width) *
                          static_cast<std::size_t>(stored));
    ByteReader reader(texture.layers.front().front());
    for (int y = texture.height - 1; y >= 0; --y) {
        const auto bytes = reader.take(row.size() * sizeof(Code));
        std::memcpy(row.data(), bytes.data(), bytes.size());
        to_or_from_little_endian<Code>(row);
        copy_texels<Code>(row, stored, pixels.row(y), pixels.channels());
    }
    return pixels;
}

void check_storable(const Picture& picture) {
    if (picture.groups.size() != 1 || !picture.groups.front().has_codes() ||
        picture.groups.front().channels() == 2) {
        throw std::invalid_argument(
            "a texture stores one group of 1, 3 or 4 channels of integers of 8 or 16 bits");
    }
}

}  // namespace

PixelFormat pixel_format_of(const Picture& picture, const GpuEncoding& encoding) {
    const ChannelGroup& group = picture.groups.front();
    const int channels = group.channels();
    if (group.type == SampleType::Uint16) {
        return channels == 1                                  ? PixelFormat::R16
               : channels == 3 && encoding.used_channels == 2 ? PixelFormat::Rg16
                                                              : PixelFormat::Rgba16;
    }
    const bool color = picture.metadata.color;
    if (encoding.blocks == BlockCompression::None || encoding.meaning == TexelMeaning::Ids ||
        !has_whole_blocks(picture.width(), picture.height())) {
        return channels == 1 ? PixelFormat::R8
               : color       ? PixelFormat::Rgba8Srgb
                             : PixelFormat::Rgba8;
    }
    if (encoding.meaning == TexelMeaning::Normals) {
        return PixelFormat::Bc5;
    }
    return channels == 1 ? PixelFormat::Bc4 : color ? PixelFormat::Bc7Srgb : PixelFormat::Bc7;
}

GpuTexture texture_of(const Picture& picture, const GpuEncoding& encoding) {
    check_storable(picture);
    GpuTexture texture{.format = pixel_format_of(picture, encoding),
                       .width = picture.width(),
                       .height = picture.height(),
                       .opaque = picture.groups.front().channels() < 4,
                       .layers = {{}},
                       .text = picture.metadata.text};
    std::vector<Bytes>& levels = texture.layers.front();
    if (!encoding.mip_levels) {
        levels.push_back(encode_image(picture, texture.format, encoding.threads));
        return texture;
    }
    for (const Picture& level : mip_chain(picture, encoding.meaning)) {
        levels.push_back(encode_image(level, texture.format, encoding.threads));
    }
    return texture;
}

Picture picture_of(const GpuTexture& texture) {
    const PixelFormatFacts& facts = facts_of(texture.format);
    const auto pixel_bytes = static_cast<std::uint64_t>(picture_channels(texture) * facts.bits / 8);
    const auto row_bytes = pixel_bytes * static_cast<std::uint64_t>(texture.width);
    require_texture_memory(
        row_bytes * static_cast<std::uint64_t>(texture.height), texture.width, texture.height);
    Picture picture;
    picture.metadata.color = facts.is_srgb;
    picture.metadata.text = texture.text;
    picture.groups.push_back(facts.is_compressed ? code_channels(decompressed(texture))
                             : facts.bits == 16
                                 ? code_channels(plain_picture<std::uint16_t>(texture))
                                 : code_channels(plain_picture<std::uint8_t>(texture)));
    return picture;
}

}  // namespace foam::texgen
