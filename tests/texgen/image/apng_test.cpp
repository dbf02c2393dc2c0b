// SPDX-License-Identifier: Apache-2.0

#include "texgen/image/apng.h"

#include "tests/texgen/image/png_chunks.h"
#include "tests/texgen/pictures.h"
#include "texgen/image/png.h"

#include <gtest/gtest.h>

#include <stdexcept>
#include <string>
#include <vector>

namespace foam::texgen {
namespace {

constexpr FrameRate kRate{24, 1};

/// Returns a picture of `width` x 3 pixels whose samples depend on `number`.
Image<std::uint8_t> picture(int number, int width = 5) {
    Image<std::uint8_t> image(width, 3, 3);
    int k = 0;
    for (std::uint8_t& sample : image.samples()) {
        sample = static_cast<std::uint8_t>(number * 90 + 3 * k++);
    }
    return image;
}

Bytes stream_of(int number, int width = 5) {
    return encode_png(picture(number, width).view(), {.color = true, .text = {{"Seed", "7"}}}, {});
}

Bytes animation(int frames, FrameRate rate = kRate) {
    ApngMuxer muxer(frames, rate);
    for (int k = 0; k < frames; ++k) {
        muxer.add(stream_of(k));
    }
    return muxer.finish();
}

TEST(Apng, HasTheChunksOfTheSpecification) {
    std::string types;
    for (const auto& [type, content] : chunks_of(animation(3))) {
        types += type + " ";
    }
    EXPECT_EQ(types, "IHDR gAMA sRGB cHRM tEXt acTL fcTL IDAT fcTL fdAT fcTL fdAT IEND ");
}

// The content is the number of frames and the number of repetitions, where 0 means for ever. The
// high byte of a number is first.
TEST(Apng, CountsFramesAndPlaysForEver) {
    EXPECT_EQ(chunk(animation(3), "acTL"), std::string("\0\0\0\3\0\0\0\0", 8));
}

// The content is a sequence number, width, height, x and y offset, the delay as a fraction of a
// second, and the modes of disposal and blending, which are 0.
TEST(Apng, ShowsEveryFrameForTheTimeOfOne) {
    const Bytes stream = animation(2, {30000, 1001});
    std::vector<std::string> controls;
    for (const auto& [type, content] : chunks_of(stream)) {
        if (type == "fcTL") {
            controls.push_back(content);
        }
    }
    const std::string rest("\0\0\0\5\0\0\0\3\0\0\0\0\0\0\0\0\x03\xe9\x75\x30\0\0", 22);
    ASSERT_EQ(controls.size(), 2U);
    EXPECT_EQ(controls[0], std::string("\0\0\0\0", 4) + rest);
    EXPECT_EQ(controls[1], std::string("\0\0\0\1", 4) + rest);
}

// A chunk fdAT has a sequence number and the zlib stream of the PNG of its frame.
TEST(Apng, KeepsTheDataOfEveryFrame) {
    const Bytes stream = animation(3);
    EXPECT_EQ(chunk(stream, "IDAT"), chunk(stream_of(0), "IDAT"));
    std::vector<std::string> data;
    for (const auto& [type, content] : chunks_of(stream)) {
        if (type == "fdAT") {
            data.push_back(content);
        }
    }
    ASSERT_EQ(data.size(), 2U);
    EXPECT_EQ(data[0], std::string("\0\0\0\2", 4) + chunk(stream_of(1), "IDAT"));
    EXPECT_EQ(data[1], std::string("\0\0\0\4", 4) + chunk(stream_of(2), "IDAT"));
}

// libpng does not support animations. It checks the CRC of every chunk.
TEST(Apng, ShowsItsFirstFrameInProgramsWithoutApngSupport) {
    const Picture read = decode_png(animation(2));
    EXPECT_EQ(codes8(read), picture(0));
    EXPECT_TRUE(read.metadata.color);
    EXPECT_EQ(read.metadata.text.size(), 1U);
}

TEST(Apng, RejectsInvalidAnimations) {
    try {
        ApngMuxer(0, FrameRate{24000, 1001});
        FAIL();
    } catch (const std::invalid_argument& error) {
        EXPECT_EQ(std::string(error.what()),
                  "an animation needs at least one frame, and a frame rate whose numerator and "
                  "denominator are from 1 to 65535, not 0 frames at 24000/1001");
    }
    EXPECT_THROW(ApngMuxer(1, FrameRate{0, 1}), std::invalid_argument);
    EXPECT_THROW(ApngMuxer(1, FrameRate{24, 65536}), std::invalid_argument);
    ApngMuxer muxer(2, kRate);
    muxer.add(stream_of(0));
    EXPECT_THROW(muxer.add(stream_of(1, 6)), std::invalid_argument);
    EXPECT_THROW(muxer.finish(), std::invalid_argument);
    muxer.add(stream_of(1));
    EXPECT_THROW(muxer.add(stream_of(2)), std::invalid_argument);
}

TEST(Apng, RejectsInvalidFrames) {
    ApngMuxer muxer(1, kRate);
    EXPECT_THROW(muxer.add({}), std::invalid_argument);
    Bytes cut = stream_of(0);
    cut.pop_back();
    EXPECT_THROW(muxer.add(cut), std::invalid_argument);
    EXPECT_NO_THROW(muxer.add(stream_of(0)));
}

}  // namespace
}  // namespace foam::texgen
