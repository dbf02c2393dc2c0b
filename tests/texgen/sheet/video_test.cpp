// SPDX-License-Identifier: Apache-2.0

#include "texgen/sheet/video.h"

#include "tests/support/temporary_folder.h"
#include "texgen/image/apng.h"
#include "texgen/image/external_program.h"
#include "texgen/image/png.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <string>

namespace foam::texgen {
namespace {

Bytes animation_of_size(int width, int height) {
    const FrameRate rate{24, 1};
    ApngMuxer muxer(2, rate);
    for (int k = 0; k < 2; ++k) {
        muxer.add(encode_png(Image<std::uint8_t>(width, height, 3).view(), {.color = true}, {}));
    }
    return encode_video(muxer.finish(), rate, VideoFormat::Mp4);
}

/// Returns "WIDTHxHEIGHT" of a video.
std::string size_of(const Bytes& video) {
    const TemporaryFolder folder;
    const std::filesystem::path file = folder.path() / "video.mp4";
    const std::filesystem::path size = folder.path() / "size";
    write_file(file, video);
    const std::string command =
        "ffprobe -v error -show_entries stream=width,height -of csv=p=0:s=x '" + file.string() +
        "' >'" + size.string() + "'";
    EXPECT_EQ(run_external({"sh", "-c", command}), 0);
    std::string text;
    std::ifstream(size) >> text;
    return text;
}

// The size of an MP4 is even: odd sizes lose a pixel, but one pixel cannot be lost.
TEST(Video, HasAnEvenSizeOfAtLeastTwoPixels) {
    if (run_external({"sh", "-c", "command -v ffmpeg ffprobe"}) != 0) {
        GTEST_SKIP() << "there is no ffmpeg";
    }
    EXPECT_EQ(size_of(animation_of_size(5, 4)), "4x4");
    EXPECT_EQ(size_of(animation_of_size(1, 5)), "2x4");
    EXPECT_EQ(size_of(animation_of_size(5, 1)), "4x2");
    EXPECT_EQ(size_of(animation_of_size(1, 1)), "2x2");
}

}  // namespace
}  // namespace foam::texgen
