// SPDX-License-Identifier: Apache-2.0

#include "texgen/image/pixel_format.h"

#include "texgen/blocks/texel_block.h"

#include <algorithm>
#include <array>
#include <bit>

namespace foam::texgen {

namespace {

// The rows are in the order of PixelFormat. The first number of a row is from DXGI_FORMAT in
// dxgiformat.h, the second from VkFormat in the Vulkan specification.
constexpr std::array<PixelFormatFacts, 10> kFormatFacts{
    {{PixelFormat::R8, "R8_UNORM", 61, 9, 1, 8, false, false, 1},
     {PixelFormat::R16, "R16_UNORM", 56, 70, 1, 16, false, false, 2},
     {PixelFormat::Rg16, "R16G16_UNORM", 35, 77, 2, 16, false, false, 4},
     {PixelFormat::Rgba8, "R8G8B8A8_UNORM", 28, 37, 4, 8, false, false, 4},
     {PixelFormat::Rgba8Srgb, "R8G8B8A8_UNORM_SRGB", 29, 43, 4, 8, false, true, 4},
     {PixelFormat::Rgba16, "R16G16B16A16_UNORM", 11, 91, 4, 16, false, false, 8},
     {PixelFormat::Bc4, "BC4_UNORM", 80, 139, 1, 8, true, false, 8},
     {PixelFormat::Bc5, "BC5_UNORM", 83, 141, 2, 8, true, false, 16},
     {PixelFormat::Bc7, "BC7_UNORM", 98, 145, 4, 8, true, false, 16},
     {PixelFormat::Bc7Srgb, "BC7_UNORM_SRGB", 99, 146, 4, 8, true, true, 16}}};

std::optional<PixelFormat> find_format_by(std::uint32_t PixelFormatFacts::*member,
                                          std::uint32_t number) {
    const auto* const found = std::ranges::find(kFormatFacts, number, member);
    return found != kFormatFacts.end() ? std::optional(found->format) : std::nullopt;
}

}  // namespace

const PixelFormatFacts& facts_of(PixelFormat format) {
    return kFormatFacts.at(static_cast<std::size_t>(format));
}

std::optional<PixelFormat> find_dxgi_format(std::uint32_t number) {
    return find_format_by(&PixelFormatFacts::dxgi, number);
}

std::optional<PixelFormat> find_vulkan_format(std::uint32_t number) {
    return find_format_by(&PixelFormatFacts::vulkan, number);
}

std::size_t image_bytes(PixelFormat format, int width, int height) {
    const PixelFormatFacts& facts = facts_of(format);
    const int side = facts.is_compressed ? kBlockSide : 1;
    const auto units = [side](int extent) {
        return static_cast<std::size_t>((extent + side - 1) / side);
    };
    return units(width) * units(height) * facts.unit_bytes;
}

int level_extent(int extent, int level) {
    return std::max(1, extent >> level);
}

int full_level_count(int width, int height) {
    return static_cast<int>(std::bit_width(static_cast<unsigned>(std::max(width, height))));
}

}  // namespace foam::texgen
