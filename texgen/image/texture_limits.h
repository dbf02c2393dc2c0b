// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <cstdint>
#include <string_view>

namespace foam::texgen {

/// The largest number of layers of an array texture, as in Direct3D 11.
inline constexpr std::uint32_t kMaxLayers = 2048;

/// Checks the sizes in the header of a texture before memory is allocated for its images. `format`
/// is the name of the file format, for the message. Throws InputError in these cases:
/// - `width`, `height`, `levels` or `layers` is 0.
/// - The image is above the limits in core/files/input_limits.h.
/// - There are more mip levels than an image of this size has (full_level_count).
/// - There are more than kMaxLayers layers.
void check_texture_size(std::string_view format,
                        std::uint32_t width,
                        std::uint32_t height,
                        std::uint32_t levels,
                        std::uint32_t layers);

/// Throws InputError unless `holds` is true. `property` is a property of a valid file that foamtex
/// does not support. The message is, for example, "the KTX2 is a cube, which foamtex does not
/// read".
void check_supported(std::string_view format, bool holds, std::string_view property);

/// Throws OutOfMemory if the machine has too little memory for `bytes` bytes of a texture. `width`
/// and `height` are the size of the texture, which the message states.
void require_texture_memory(std::uint64_t bytes, int width, int height);

}  // namespace foam::texgen
