// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/files/file_io.h"
#include "texgen/animation/progress_meter.h"
#include "texgen/image/gpu_texture.h"
#include "texgen/image/pixel_format.h"
#include "texgen/sheet/map_sequence.h"

#include <filesystem>

namespace foam::texgen {

/// An array texture whose file has been staged (StagedFile).
struct StagedArray {
    StagedFile file;
    PixelFormat format = PixelFormat::Rgba8;
    int mip_levels = 1;
};

/// Reads the frames of a map and stages a file of an array texture, which has one layer per frame
/// (GpuTexture). `path` ends in the suffix of a TextureFormat. Frames that are textures themselves
/// are copied without any change, with their mip levels. Frames of codes, such as PNGs, are encoded
/// with all mip levels (texture_of). Several frames are encoded at once, on all threads. The memory
/// contains the whole array, the encoded file and one frame per thread. `progress` counts each
/// frame; the last frame counts when the file has been staged.
///
/// `animation` is stored in the file if the file format supports this.
///
/// Throws InputError, whose message names the file, in these cases:
/// - A file cannot be read, or is an array texture of several layers.
/// - A file differs from the first frame in its size, pixel format or number of mip levels.
/// - The samples of a file are not codes (integers of 8 or 16 bits).
/// Throws OutputError if the array cannot be written. Precondition: the sequence has at least one
/// file.
StagedArray stage_array(const MapSequence& sequence,
                        const TextureAnimation& animation,
                        const std::filesystem::path& path,
                        ProgressMeter& progress);

}  // namespace foam::texgen
