// SPDX-License-Identifier: Apache-2.0

#include "tests/support/temporary_folder.h"
#include "tests/texgen/image/numbered.h"
#include "tests/texgen/pictures.h"
#include "texgen/image/exr.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cstring>
#include <string>

namespace foam::texgen {
namespace {

Image<std::uint32_t> numbered_ids(int width, int height) {
    Image<std::uint32_t> ids(width, height, 1);
    std::uint32_t id = 4'000'000'000;
    for (std::uint32_t& sample : ids.samples()) {
        sample = id++;
    }
    return ids;
}

/// Returns one channel of an image as an image of one channel.
Image<float> channel_of(const Image<float>& image, int channel) {
    Image<float> alone(image.width(), image.height(), 1);
    for (int y = 0; y < image.height(); ++y) {
        for (int x = 0; x < image.width(); ++x) {
            alone.pixel(x, y)[0] = image.pixel(x, y)[static_cast<std::size_t>(channel)];
        }
    }
    return alone;
}

// Only colors have primaries.
TEST(ExrDecode, PrimariesRoundTrip) {
    const Image<float> image = numbered_floats(2, 2, 3);
    const std::vector<ExrChannel> channels = {{"R", SampleType::Float, image.view(), 0}};
    for (const Primaries primaries : {Primaries::Srgb, Primaries::AcesCg}) {
        const Bytes colors = encode_exr(channels, {.color = true, .primaries = primaries});
        EXPECT_EQ(decode_exr(colors).metadata.primaries, primaries);
        const Bytes data = encode_exr(channels, {.primaries = primaries});
        EXPECT_FALSE(decode_exr(data).metadata.color);
        EXPECT_EQ(decode_exr(data).metadata.primaries, Primaries::Srgb);
    }
}

RC_GTEST_PROP(ExrDecode, PixelsAndTextsRoundTrip, ()) {
    const int width = *rc::gen::inRange(1, 90);
    const int height = *rc::gen::inRange(1, 70);
    const Image<float> image = numbered_floats(width, height, 3);
    const Image<std::uint32_t> ids = numbered_ids(width, height);
    const std::vector<ExrChannel> channels = {{"normal.X", SampleType::Half, image.view(), 0},
                                              {"height.Y", SampleType::Float, image.view(), 2},
                                              {"id.Y", SampleType::Uint32, ids.view()}};
    const ImageMetadata metadata{.color = *rc::gen::arbitrary<bool>(),
                                 .periodic = *rc::gen::arbitrary<bool>(),
                                 .frame_rate = FrameRate{24000, 1001},
                                 .text = {{"Preset", "[foam]\n"}, {"Seed", "7"}}};
    const ExrEncoding encoding{.compression = static_cast<ExrCompression>(*rc::gen::inRange(0, 5)),
                               .zip_level = *rc::gen::inRange(1, 10),
                               .mip_levels = *rc::gen::arbitrary<bool>()};

    const Picture back = decode_exr(encode_exr(channels, metadata, encoding));
    RC_ASSERT(back.groups.size() == 3U);  // in the order of their names
    RC_ASSERT(back.groups[0].names.front() == "height.Y");
    RC_ASSERT(back.groups[0].type == SampleType::Float);
    RC_ASSERT(floats(back.groups[0]) == channel_of(image, 2));
    RC_ASSERT(back.groups[1].names.front() == "id.Y");
    RC_ASSERT(back.groups[1].type == SampleType::Uint32);
    RC_ASSERT(integers(back.groups[1]) == ids);
    RC_ASSERT(back.groups[2].names.front() == "normal.X");
    RC_ASSERT(back.groups[2].type == SampleType::Half);
    RC_ASSERT(floats(back.groups[2]) == channel_of(image, 0));
    RC_ASSERT(back.metadata.color == metadata.color);
    RC_ASSERT(back.metadata.periodic == metadata.periodic);
    RC_ASSERT(back.metadata.frame_rate == metadata.frame_rate);
    RC_ASSERT(back.metadata.text == metadata.text);
}

/// Returns an EXR with the channel Y.
Bytes encoded(SampleType type, const Image<float>& image, const ExrEncoding& encoding = {}) {
    const ExrChannel channel{"Y", type, image.view()};
    return encode_exr(std::span(&channel, 1), {}, encoding);
}

TEST(ExrDecode, EveryTruncationIsAnInputError) {
    const Bytes stream = encoded(SampleType::Half, numbered_floats(5, 20, 1));
    for (std::size_t size = 0; size < stream.size(); ++size) {
        EXPECT_THROW(decode_exr(std::span(stream).first(size)), InputError) << size;
    }
}

// The size in the attribute dataWindow, a box2i of 16 bytes, is changed to 900000 x 900000 pixels.
// The file must be rejected before memory for the pixels is allocated.
TEST(ExrDecode, AHeaderOfAHugeImageIsAnInputError) {
    Bytes stream = encoded(SampleType::Half, Image<float>(1, 1, 1));
    const std::string text(reinterpret_cast<const char*>(stream.data()), stream.size());
    const std::size_t box = text.find("dataWindow") + 11 + std::string("box2i").size() + 1 + 4;
    const std::array<std::int32_t, 4> window = {0, 0, 899'999, 899'999};
    std::memcpy(&stream[box], window.data(), sizeof window);
    EXPECT_THROW(decode_exr(stream), InputError);
}

TEST(ExrDecode, AMalformedFileIsNamed) {
    const TemporaryFolder folder;
    const auto path = folder.path() / "a.exr";
    write_file(path, Bytes(20));
    try {
        read_picture(path);
        FAIL();
    } catch (const InputError& error) {
        const std::string message = error.what();
        EXPECT_EQ(message,
                  "cannot read '" + path.string() + "': unreadable EXR: not an EXR of version 2");
    }
}

TEST(ExrDecode, FilesAreReadAsWritten) {
    const TemporaryFolder folder;
    const Image<float> image = numbered_floats(5, 7, 1);
    const ExrChannel channel{"Y", SampleType::Half, image.view()};
    write_exr(folder.path() / "a.exr", std::span(&channel, 1), {.periodic = true});
    const Picture back = read_picture(folder.path() / "a.exr");
    EXPECT_EQ(floats(back.groups[0]), image);
    EXPECT_TRUE(back.metadata.periodic);
    EXPECT_EQ(folder.files(), std::vector<std::string>{"a.exr"});
}

}  // namespace
}  // namespace foam::texgen
