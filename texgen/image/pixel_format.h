// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>

namespace foam::texgen {

/// A pixel format of a texture for graphics hardware. Channels are red, green, blue and alpha, in
/// this order. Samples are unsigned integers (codes); the largest code represents 1.
enum class PixelFormat : std::uint8_t {
    R8,         // one channel of 8 bits
    R16,        // one channel of 16 bits
    Rg16,       // two channels of 16 bits
    Rgba8,      // four channels of 8 bits
    Rgba8Srgb,  // the same with colors that are encoded as sRGB
    Rgba16,     // four channels of 16 bits
    Bc4,        // one channel, compressed
    Bc5,        // two channels, compressed
    Bc7,        // four channels, compressed
    Bc7Srgb,    // the same with colors that are encoded as sRGB
};

/// The facts about a pixel format.
struct PixelFormatFacts {
    PixelFormat format;
    std::string_view name;  // the name in Direct3D, without "DXGI_FORMAT_"
    std::uint32_t dxgi;     // the number of the format in Direct3D (DXGI_FORMAT)
    std::uint32_t vulkan;   // the number of the format in Vulkan (VkFormat)
    int channels = 0;
    int bits = 8;                // bits per sample
    bool is_compressed = false;  // true if 4 x 4 texels are compressed to one block
    bool is_srgb = false;
    std::size_t unit_bytes = 0;  // bytes of a texel or, in a compressed format, of a block
};

const PixelFormatFacts& facts_of(PixelFormat format);

/// Return the format that has this number in Direct3D or in Vulkan, or nullopt if there is none.
std::optional<PixelFormat> find_dxgi_format(std::uint32_t number);
std::optional<PixelFormat> find_vulkan_format(std::uint32_t number);

/// Returns the number of bytes of an image of this format.
std::size_t image_bytes(PixelFormat format, int width, int height);

/// Returns the width or height of a mip level. Level 0 has the full size.
int level_extent(int extent, int level);

/// Returns the number of mip levels from the full size to 1 x 1.
int full_level_count(int width, int height);

}  // namespace foam::texgen
