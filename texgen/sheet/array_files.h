// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/files/file_io.h"
#include "texgen/animation/progress_meter.h"
#include "texgen/image/gpu_texture.h"
#include "texgen/image/pixel_format.h"
#include "texgen/sheet/map_sequence.h"

#include <filesystem>

namespace foam::texgen {

/// An array texture whose file has been staged.
struct StagedArray {
    StagedFile file;
    PixelFormat format = PixelFormat::Rgba8;
};

/// Reads the frames of a map and stages a file of an array texture, which has a layer with all mip
/// levels for each frame (GpuTexture). The suffix of `path` is that of a TextureFormat. Frames that
/// are textures themselves are copied without any change.
/// Frames of codes, such as PNGs, are encoded as texture_of does, several frames at once on
/// all threads. The memory contains the whole array, the encoded file and one frame per thread.
/// `progress` counts each frame; the last frame counts when the file has been written.
///
/// `animation` is stored in the file if the file format supports this.
///
/// Throws InputError if a file cannot be read, if its size or its format differs from that of the
/// first frame, or if its samples are not codes. Throws OutputError if the array cannot be written.
StagedArray stage_array(const MapSequence& sequence,
                        const TextureAnimation& animation,
                        const std::filesystem::path& path,
                        ProgressMeter& progress);

}  // namespace foam::texgen
