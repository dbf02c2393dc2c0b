// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/files/file_io.h"
#include "texgen/image/exr.h"
#include "texgen/image/format.h"

#include <cstdint>
#include <filesystem>
#include <span>
#include <variant>

namespace foam::texgen {

/// Returns the samples of the first group of a picture, which must be codes of 8 bits (`codes8`) or
/// of 16 bits (`codes16`).
inline Image<std::uint8_t> codes8(const Picture& picture) {
    return std::get<Image<std::uint8_t>>(picture.groups.at(0).samples);
}
inline Image<std::uint16_t> codes16(const Picture& picture) {
    return std::get<Image<std::uint16_t>>(picture.groups.at(0).samples);
}

/// Returns the samples of a channel group, which must be floats (`floats`) or unsigned integers
/// (`integers`).
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
