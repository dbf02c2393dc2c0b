// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/files/file_io.h"
#include "texgen/image/frame_rate.h"
#include "texgen/image/mip_chain.h"
#include "texgen/image/picture.h"
#include "texgen/image/pixel_format.h"

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace foam::texgen {

/// Selects the images that are compressed in blocks of 4 x 4 texels. Graphics hardware reads such
/// blocks directly.
enum class BlockCompression {
    Auto,  // images of 8 bits whose width and height are multiples of 4, except ids
    None,  // no image
};

/// Options for textures of graphics hardware (DDS and KTX2).
struct GpuEncoding {
    BlockCompression blocks = BlockCompression::Auto;
    bool mip_levels = true;  // if false, only the full size is stored
    TexelMeaning meaning = TexelMeaning::Numbers;
    /// The number of channels of the picture that contain data, or 0 if all channels do. If it is 2
    /// for a picture of three channels, the third channel is 0 everywhere, and a texture of 16 bits
    /// omits this channel (Rg16). All other values have no effect.
    int used_channels = 0;
    /// The number of threads that compress; 0 or less means as many as the hardware runs at once.
    /// The bytes do not depend on the number of threads.
    int threads = 1;
};

/// The playback of the layers of an array texture as an animation.
struct TextureAnimation {
    FrameRate rate;
    bool repeats = false;  // true if the first layer follows the last one; false to play once

    friend bool operator==(const TextureAnimation&, const TextureAnimation&) = default;
};

/// A texture as graphics hardware reads it: images of all layers and mip levels. The rows of an
/// image run from the top to the bottom.
struct GpuTexture {
    PixelFormat format = PixelFormat::Rgba8;
    int width = 0;
    int height = 0;
    bool is_array = false;  // true for an array texture, which may have any number of layers
    bool opaque = true;     // for four channels: true if the fourth one is not an alpha channel
    std::vector<std::vector<Bytes>> layers;  // for each layer: its mip levels, the full size first
    std::vector<std::pair<std::string, std::string>> text;  // ImageMetadata::text
    /// Set if the layers of an array are frames of an animation. A DDS cannot store it.
    std::optional<TextureAnimation> animation = {};

    int levels() const { return static_cast<int>(layers.front().size()); }
};

/// Returns the format in which a picture of codes is stored:
///
/// | picture | 8 bits, compressed | 8 bits, not compressed | 16 bits |
/// |---|---|---|---|
/// | colors | Bc7Srgb | Rgba8Srgb | |
/// | one channel | Bc4 | R8 | R16 |
/// | normals | Bc5, without z | Rgba8 | Rgba16 |
/// | two used channels | Bc7 | Rgba8 | Rg16 |
/// | other data | Bc7 | Rgba8 | Rgba16 |
///
/// Ids are not compressed. A picture whose width or height is not a multiple of 4 is not compressed
/// either, because Direct3D does not allow it. Colors are expected to have 8 bits: colors of 16
/// bits would be stored as Rgba16, which does not mark them as sRGB.
PixelFormat pixel_format_of(const Picture& picture, const GpuEncoding& encoding);

/// Returns a texture of one layer that stores a picture. Throws std::invalid_argument unless the
/// picture has one group of 1, 3 or 4 channels of codes.
GpuTexture texture_of(const Picture& picture, const GpuEncoding& encoding);

/// Returns the full size of the first layer of a texture as a picture. The format of the texture
/// determines the number of channels of the picture:
/// - A format of one channel gives one channel.
/// - Rg16, a format of two channels, gives three channels. The third one is 0.
/// - Bc5, a format of two channels, gives three channels: x, y and z of a unit vector. The
///   texture stores only x and y.
/// - A format of four channels gives four channels, or three if the texture has no alpha
///   (`opaque`).
///
/// Throws OutOfMemory if the machine has too little memory for the picture.
Picture picture_of(const GpuTexture& texture);

}  // namespace foam::texgen
