// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/image/exr.h"
#include "texgen/image/file_io.h"
#include "texgen/image/format.h"

#include <cstdint>
#include <filesystem>
#include <span>
#include <variant>

namespace foam::texgen {

/// Returns the samples of a picture of one group of 8-bit or 16-bit codes.
inline Image<std::uint8_t> codes8(const Picture& picture) {
    return std::get<Image<std::uint8_t>>(picture.groups.at(0).samples);
}
inline Image<std::uint16_t> codes16(const Picture& picture) {
    return std::get<Image<std::uint16_t>>(picture.groups.at(0).samples);
}

/// Returns the samples of the only channel of a group.
inline const Image<float>& floats(const ChannelGroup& group) {
    return std::get<Image<float>>(group.samples);
}
inline const Image<std::uint32_t>& integers(const ChannelGroup& group) {
    return std::get<Image<std::uint32_t>>(group.samples);
}

inline void write_exr(const std::filesystem::path& path,
                      std::span<const ExrChannel> channels,
                      const ImageMetadata& metadata = {},
                      const ExrEncoding& encoding = {}) {
    write_file(path, encode_exr(channels, metadata, encoding));
}

}  // namespace foam::texgen
