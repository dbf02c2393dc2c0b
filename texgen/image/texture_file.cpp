// SPDX-License-Identifier: Apache-2.0

#include "texgen/image/texture_file.h"

#include "texgen/image/dds.h"
#include "texgen/image/file_suffix.h"
#include "texgen/image/ktx2.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>

namespace foam::texgen {

namespace {

constexpr std::array kTextureFormats = {TextureFormat{".dds", encode_dds, decode_dds},
                                        TextureFormat{".ktx2", encode_ktx2, decode_ktx2}};

}  // namespace

const TextureFormat* find_texture_format(std::string_view file_name) {
    const auto* const found = std::ranges::find_if(
        kTextureFormats,
        [&](const TextureFormat& format) { return has_suffix(file_name, format.suffix); });
    return found != kTextureFormats.end() ? found : nullptr;
}

Bytes encode_picture(const TextureFormat& format,
                     const Picture& picture,
                     const GpuEncoding& encoding) {
    return format.encode(texture_of(picture, encoding));
}

Picture decode_picture(const TextureFormat& format, std::span<const std::byte> content) {
    const GpuTexture texture = format.decode(content);
    if (texture.layers.size() > 1) {
        throw InputError(fmt::format("the file is an array of {} layers, not a single image",
                                     texture.layers.size()));
    }
    return picture_of(texture);
}

}  // namespace foam::texgen
