#pragma once

#include "texgen/image/file_io.h"
#include "texgen/image/frame_rate.h"

#include <cstddef>
#include <span>

namespace foam::texgen {

/// Films that the program `ffmpeg` makes, where it is installed.
enum class VideoFormat {
    Mp4,  // H.264, 4:2:0, as all players take it; at an odd extent the last pixel is left out
    Gif,  // 256 colours, over and over
};

/// Throws OutputError unless ffmpeg is there.
void check_ffmpeg();

/// From an animated PNG of this rate, which ffmpeg reads from it with an error of 1e-4. Throws
/// OutputError where ffmpeg is missing or fails; it says on stderr why.
Bytes encode_video(std::span<const std::byte> apng, FrameRate rate, VideoFormat format);

}  // namespace foam::texgen
