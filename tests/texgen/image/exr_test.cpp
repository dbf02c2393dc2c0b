#include "texgen/image/exr.h"

#include "tests/texgen/temporary_folder.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <cstring>
#include <limits>
#include <stdexcept>
#include <string>

namespace foam::texgen {
namespace {

/// Multiples of 1/8 below 32, which a half holds exactly.
Image<float> numbered(int width, int height, int channels) {
    Image<float> image(width, height, channels);
    int k = 0;
    for (float& sample : image.samples()) {
        sample = static_cast<float>(k++ % 256) / 8.0F - 4.0F;
    }
    return image;
}

Image<std::uint32_t> numbered_ids(int width, int height) {
    Image<std::uint32_t> ids(width, height, 1);
    std::uint32_t id = 4'000'000'000;
    for (std::uint32_t& sample : ids.samples()) {
        sample = id++;
    }
    return ids;
}

const Image<float>& floats(const ExrPlane& plane) {
    return std::get<Image<float>>(plane.pixels);
}

const Image<std::uint32_t>& integers(const ExrPlane& plane) {
    return std::get<Image<std::uint32_t>>(plane.pixels);
}

/// What was written of a channel, alone.
Image<float> channel_of(const Image<float>& image, int channel) {
    Image<float> alone(image.width(), image.height(), 1);
    for (int y = 0; y < image.height(); ++y) {
        for (int x = 0; x < image.width(); ++x) {
            alone.pixel(x, y)[0] = image.pixel(x, y)[static_cast<std::size_t>(channel)];
        }
    }
    return alone;
}

RC_GTEST_PROP(Exr, PixelsAndTextsComeBack, ()) {
    const int width = *rc::gen::inRange(1, 90);
    const int height = *rc::gen::inRange(1, 70);
    const Image<float> image = numbered(width, height, 3);
    const Image<std::uint32_t> ids = numbered_ids(width, height);
    const std::vector<ExrChannel> channels = {{"normal.X", ExrType::Half, image.view(), 0},
                                              {"height.Y", ExrType::Float, image.view(), 2},
                                              {"id.Y", ExrType::Uint, ids.view()}};
    const ExrMetadata metadata{.color = *rc::gen::arbitrary<bool>(),
                               .periodic = *rc::gen::arbitrary<bool>(),
                               .frame_rate = FrameRate{24000, 1001},
                               .text = {{"Preset", "[foam]\n"}, {"Seed", "7"}}};
    const ExrEncoding encoding{.compression = static_cast<ExrCompression>(*rc::gen::inRange(0, 5)),
                               .zip_level = *rc::gen::inRange(1, 10),
                               .mip_levels = *rc::gen::arbitrary<bool>()};

    const ExrImage back = decode_exr(encode_exr(channels, metadata, encoding));
    RC_ASSERT(back.channels.size() == 3U);  // in the order of their names
    RC_ASSERT(back.channels[0].name == "height.Y");
    RC_ASSERT(back.channels[0].type == ExrType::Float);
    RC_ASSERT(floats(back.channels[0]) == channel_of(image, 2));
    RC_ASSERT(back.channels[1].name == "id.Y");
    RC_ASSERT(back.channels[1].type == ExrType::Uint);
    RC_ASSERT(integers(back.channels[1]) == ids);
    RC_ASSERT(back.channels[2].name == "normal.X");
    RC_ASSERT(back.channels[2].type == ExrType::Half);
    RC_ASSERT(floats(back.channels[2]) == channel_of(image, 0));
    RC_ASSERT(back.metadata.color == metadata.color);
    RC_ASSERT(back.metadata.periodic == metadata.periodic);
    RC_ASSERT(back.metadata.frame_rate == metadata.frame_rate);
    RC_ASSERT(back.metadata.text == metadata.text);
}

/// A file of one channel.
Bytes encoded(ExrType type, const Image<float>& image, const ExrEncoding& encoding = {}) {
    const ExrChannel channel{"Y", type, image.view()};
    return encode_exr(std::span(&channel, 1), {}, encoding);
}

TEST(Exr, NothingIsHeldAtZeroOrOne) {
    Image<float> image(4, 1, 1);
    const std::vector<float> values = {-65504.0F, 65504.0F, 1.0e-7F, 1.0e30F};
    std::ranges::copy(values, image.samples().begin());
    EXPECT_EQ(floats(decode_exr(encoded(ExrType::Float, image)).channels[0]), image);
    image.samples()[3] = 2.0F;
    const Image<float> back = floats(decode_exr(encoded(ExrType::Half, image)).channels[0]);
    EXPECT_EQ(back.samples()[0], -65504.0F);
    EXPECT_EQ(back.samples()[1], 65504.0F);
    EXPECT_NEAR(back.samples()[2], 1.0e-7F, std::ldexp(1.0F, -25));  // half of a half's least step
}

// 65520 is half way from the largest half to the next power of two, and would become infinite.
TEST(Exr, RefusesWhatTheTypeCannotHold) {
    Image<float> image(1, 1, 1);
    image.samples()[0] = 65519.0F;
    EXPECT_NO_THROW(encoded(ExrType::Half, image));
    image.samples()[0] = 65520.0F;
    EXPECT_THROW(encoded(ExrType::Half, image), std::invalid_argument);
    EXPECT_NO_THROW(encoded(ExrType::Float, image));
    for (const float number : {std::numeric_limits<float>::infinity(), std::nanf("")}) {
        image.samples()[0] = number;
        EXPECT_THROW(encoded(ExrType::Float, image), std::invalid_argument);
    }
}

// Without compression, a row of the file is its number, its size and its samples; the number of
// the top row is 0.
TEST(Exr, TheTopRowComesFirstInTheFile) {
    Image<float> image(1, 2, 1);
    image.row(0)[0] = 1.0F;  // bottom
    image.row(1)[0] = 2.0F;
    const Bytes stream = encoded(ExrType::Float, image, {.compression = ExrCompression::None});
    std::array<float, 2> samples{};
    std::memcpy(&samples[0], &stream[stream.size() - 16], 4);
    std::memcpy(&samples[1], &stream[stream.size() - 4], 4);
    EXPECT_EQ(samples, (std::array{2.0F, 1.0F}));
}

TEST(Exr, TheBytesDoNotDependOnTheNumberOfThreads) {
    const Image<float> image = numbered(200, 150, 1);
    for (const bool mip_levels : {false, true}) {
        const auto with = [&](int threads) {
            return encoded(ExrType::Half, image, {.mip_levels = mip_levels, .threads = threads});
        };
        EXPECT_EQ(with(2), with(1));
        EXPECT_EQ(with(3), with(1));
        EXPECT_EQ(with(0), with(1));
    }
}

// By hand: 4 x 2, means of 2 x 2, then of 2 x 1. Levels are 4 x 2, 2 x 1, 1 x 1.
TEST(Exr, MipLevelsAreMeansAndIdsAreChosen) {
    Image<float> image(4, 2, 1);
    const std::vector<float> values = {1, 2, 3, 4, 5, 6, 7, 8};
    std::ranges::copy(values, image.samples().begin());
    Image<std::uint32_t> ids(4, 2, 1);
    std::ranges::copy(values, ids.samples().begin());
    const std::vector<ExrChannel> channels = {{"Y", ExrType::Half, image.view()},
                                              {"id", ExrType::Uint, ids.view()}};
    const Bytes stream = encode_exr(channels, {}, {.mip_levels = true});
    const ExrImage first = decode_exr(stream, 1);
    EXPECT_EQ(floats(first.channels[0]).pixel(0, 0)[0], (1 + 2 + 5 + 6) / 4.0F);
    EXPECT_EQ(floats(first.channels[0]).pixel(1, 0)[0], (3 + 4 + 7 + 8) / 4.0F);
    EXPECT_EQ(integers(first.channels[1]).pixel(0, 0)[0], 6U);
    const ExrImage second = decode_exr(stream, 2);
    EXPECT_EQ(floats(second.channels[0]).samples().size(), 1U);
    EXPECT_EQ(floats(second.channels[0]).pixel(0, 0)[0], 36 / 8.0F);
    EXPECT_THROW(decode_exr(stream, 3), InputError);
    EXPECT_THROW(decode_exr(encoded(ExrType::Half, image), 1), InputError);
}

TEST(Exr, RefusesChannelsThatMakeNoFile) {
    const Image<float> image(3, 2, 2);
    const Image<float> other(2, 2, 1);
    const Image<std::uint32_t> ids(3, 2, 1);
    const auto make = [](const std::vector<ExrChannel>& channels) { encode_exr(channels); };
    EXPECT_THROW(make({}), std::invalid_argument);
    EXPECT_THROW(make({{"Y", ExrType::Half, ImageView<const float>()}}), std::invalid_argument);
    EXPECT_THROW(make({{"", ExrType::Half, image.view()}}), std::invalid_argument);
    EXPECT_THROW(make({{"Y", ExrType::Half, image.view(), 2}}), std::invalid_argument);
    EXPECT_THROW(make({{"Y", ExrType::Uint, image.view()}}), std::invalid_argument);
    EXPECT_THROW(make({{"Y", ExrType::Float, ids.view()}}), std::invalid_argument);
    EXPECT_THROW(make({{"Y", ExrType::Half, image.view()}, {"Y", ExrType::Half, image.view(), 1}}),
                 std::invalid_argument);
    EXPECT_THROW(make({{"X", ExrType::Half, image.view()}, {"Y", ExrType::Half, other.view()}}),
                 std::invalid_argument);
}

TEST(Exr, RefusesNamesThatExrGivesAMeaning) {
    const Image<float> image(1, 1, 1);
    const ExrChannel channel{"Y", ExrType::Half, image.view()};
    for (const std::string& name : {std::string(),
                                    std::string(32, 'k'),
                                    std::string("channels"),
                                    std::string("wrapmodes"),
                                    std::string("framesPerSecond")}) {
        EXPECT_THROW(encode_exr(std::span(&channel, 1), {.text = {{name, "x"}}}),
                     std::invalid_argument)
            << name;
    }
}

TEST(Exr, EveryTruncationIsAnInputError) {
    const Bytes stream = encoded(ExrType::Half, numbered(5, 20, 1));
    for (std::size_t size = 0; size < stream.size(); ++size) {
        EXPECT_THROW(decode_exr(std::span(stream).first(size)), InputError) << size;
    }
}

// The attribute dataWindow, a box2i of 16 bytes, made 900000 x 900000 pixels: refused before memory
// is asked for.
TEST(Exr, AHeaderThatPromisesTooMuchIsAnInputError) {
    Bytes stream = encoded(ExrType::Half, Image<float>(1, 1, 1));
    const std::string text(reinterpret_cast<const char*>(stream.data()), stream.size());
    const std::size_t box = text.find("dataWindow") + 11 + std::string("box2i").size() + 1 + 4;
    const std::array<std::int32_t, 4> window = {0, 0, 899'999, 899'999};
    std::memcpy(&stream[box], window.data(), sizeof window);
    EXPECT_THROW(decode_exr(stream), InputError);
}

TEST(Exr, AMalformedFileIsNamed) {
    const TemporaryFolder folder;
    const auto path = folder.path() / "a.exr";
    write_file(path, Bytes(20));
    try {
        read_exr(path);
        FAIL();
    } catch (const InputError& error) {
        const std::string message = error.what();
        EXPECT_EQ(message.rfind("cannot read '" + path.string() + "': malformed EXR: ", 0), 0U);
        EXPECT_EQ(message.find('\n'), std::string::npos);
    }
}

TEST(Exr, FilesAreReadAsWritten) {
    const TemporaryFolder folder;
    const Image<float> image = numbered(5, 7, 1);
    const ExrChannel channel{"Y", ExrType::Half, image.view()};
    write_exr(folder.path() / "a.exr", std::span(&channel, 1), {.periodic = true});
    const ExrImage back = read_exr(folder.path() / "a.exr");
    EXPECT_EQ(floats(back.channels[0]), image);
    EXPECT_TRUE(back.metadata.periodic);
    EXPECT_EQ(folder.files(), std::vector<std::string>{"a.exr"});
}

}  // namespace
}  // namespace foam::texgen
