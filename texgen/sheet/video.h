// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/image/file_io.h"
#include "texgen/image/frame_rate.h"

#include <cstddef>
#include <span>

namespace foam::texgen {

/// The formats of videos, which the external program `ffmpeg` encodes.
enum class VideoFormat {
    Mp4,  // H.264, 4:2:0, which all players support; an odd last column or row is cropped
    Gif,  // 256 colors, repeated endlessly
};

/// Throws OutputError if ffmpeg is not installed or does not run.
void check_ffmpeg();

/// Encodes an animated PNG as a video. Precondition: `rate` is the frame rate of the PNG. It is
/// passed to ffmpeg separately, because ffmpeg reads the rate of an animated PNG with a relative
/// error of 1e-4. Throws OutputError if ffmpeg is not installed or fails; ffmpeg prints the reason
/// to stderr.
Bytes encode_video(std::span<const std::byte> apng, FrameRate rate, VideoFormat format);

}  // namespace foam::texgen
