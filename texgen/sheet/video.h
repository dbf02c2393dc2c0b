// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/files/file_io.h"
#include "texgen/image/frame_rate.h"

#include <cstddef>
#include <span>

namespace foam::texgen {

/// A format in which the external program `ffmpeg` encodes a video.
enum class VideoFormat {
    // H.264 with 4:2:0 chroma, for wide support. A width or height of 1 pixel is doubled; any other
    // odd width or height is cropped by 1 pixel.
    Mp4,
    Gif,  // 256 colors, repeated endlessly
};

/// Throws OutputError if ffmpeg is not installed or cannot be run.
void check_ffmpeg();

/// Encodes an animated PNG as a video and returns the content of the video file. Precondition:
/// `rate` is the frame rate of the PNG. The rate is passed to ffmpeg separately, because ffmpeg
/// reads the rate of an animated PNG with a relative error of 1e-4. Throws OutputError if ffmpeg is
/// not installed or fails. If it fails, the message ends with the last lines of its error output.
Bytes encode_video(std::span<const std::byte> apng, FrameRate rate, VideoFormat format);

}  // namespace foam::texgen
