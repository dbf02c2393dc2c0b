// SPDX-License-Identifier: Apache-2.0

#include "tests/texgen/image/numbered.h"
#include "tests/texgen/pictures.h"
#include "texgen/image/exr.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <limits>
#include <stdexcept>
#include <string>

namespace foam::texgen {
namespace {

/// Returns an EXR with the channel Y.
Bytes encoded(SampleType type, const Image<float>& image, const ExrEncoding& encoding = {}) {
    const ExrChannel channel{"Y", type, image.view()};
    return encode_exr(std::span(&channel, 1), {}, encoding);
}

TEST(ExrEncode, DoesNotClampValues) {
    Image<float> image(4, 1, 1);
    const std::vector<float> values = {-65504.0F, 65504.0F, 1.0e-7F, 1.0e30F};
    std::ranges::copy(values, image.samples().begin());
    EXPECT_EQ(floats(decode_exr(encoded(SampleType::Float, image)).groups[0]), image);
    image.samples()[3] = 2.0F;
    const Image<float> back = floats(decode_exr(encoded(SampleType::Half, image)).groups[0]);
    EXPECT_EQ(back.samples()[0], -65504.0F);
    EXPECT_EQ(back.samples()[1], 65504.0F);
    // Rounding changes a number near 0 by at most half of the smallest half float, 2^-24.
    EXPECT_NEAR(back.samples()[2], 1.0e-7F, std::ldexp(1.0F, -25));
}

// The largest half float is 65504. 65520 is halfway between it and 65536, so it would be rounded to
// infinity.
TEST(ExrEncode, RejectsValuesOutOfRangeOfTheType) {
    Image<float> image(1, 1, 1);
    image.samples()[0] = 65519.0F;
    EXPECT_NO_THROW(encoded(SampleType::Half, image));
    image.samples()[0] = 65520.0F;
    EXPECT_THROW(encoded(SampleType::Half, image), std::invalid_argument);
    EXPECT_NO_THROW(encoded(SampleType::Float, image));
    for (const float number : {std::numeric_limits<float>::infinity(), std::nanf("")}) {
        image.samples()[0] = number;
        EXPECT_THROW(encoded(SampleType::Float, image), std::invalid_argument);
    }
}

// Without compression, the file has the number, the size and the samples of each row. The number of
// the top row is 0.
TEST(ExrEncode, TheTopRowComesFirstInTheFile) {
    Image<float> image(1, 2, 1);
    image.row(0)[0] = 1.0F;  // bottom
    image.row(1)[0] = 2.0F;
    const Bytes stream = encoded(SampleType::Float, image, {.compression = ExrCompression::None});
    std::array<float, 2> samples{};
    std::memcpy(&samples[0], &stream[stream.size() - 16], 4);
    std::memcpy(&samples[1], &stream[stream.size() - 4], 4);
    EXPECT_EQ(samples, (std::array{2.0F, 1.0F}));
}

TEST(ExrEncode, TheBytesDoNotDependOnTheNumberOfThreads) {
    const Image<float> image = numbered_floats(200, 150, 1);
    for (const bool mip_levels : {false, true}) {
        const auto with = [&](int threads) {
            return encoded(SampleType::Half, image, {.mip_levels = mip_levels, .threads = threads});
        };
        EXPECT_EQ(with(2), with(1));
        EXPECT_EQ(with(3), with(1));
        EXPECT_EQ(with(0), with(1));
    }
}

// Computed by hand. The levels have 4 x 2, 2 x 1 and 1 x 1 pixels. The means are over 2 x 2 pixels,
// then over 2 x 1.
TEST(ExrEncode, MipLevelsAreMeansAndIdsAreChosen) {
    Image<float> image(4, 2, 1);
    const std::vector<float> values = {1, 2, 3, 4, 5, 6, 7, 8};
    std::ranges::copy(values, image.samples().begin());
    Image<std::uint32_t> ids(4, 2, 1);
    std::ranges::copy(values, ids.samples().begin());
    const std::vector<ExrChannel> channels = {{"Y", SampleType::Half, image.view()},
                                              {"id", SampleType::Uint32, ids.view()}};
    const Bytes stream = encode_exr(channels, {}, {.mip_levels = true});
    const Picture first = decode_exr(stream, 1);
    EXPECT_EQ(floats(first.groups[0]).pixel(0, 0)[0], (1 + 2 + 5 + 6) / 4.0F);
    EXPECT_EQ(floats(first.groups[0]).pixel(1, 0)[0], (3 + 4 + 7 + 8) / 4.0F);
    EXPECT_EQ(integers(first.groups[1]).pixel(0, 0)[0], 6U);
    const Picture second = decode_exr(stream, 2);
    EXPECT_EQ(floats(second.groups[0]).samples().size(), 1U);
    EXPECT_EQ(floats(second.groups[0]).pixel(0, 0)[0], 36 / 8.0F);
    EXPECT_THROW(decode_exr(stream, 3), InputError);
    EXPECT_THROW(decode_exr(encoded(SampleType::Half, image), 1), InputError);
}

TEST(ExrEncode, RejectsChannelsThatMakeNoFile) {
    const Image<float> image(3, 2, 2);
    const Image<float> other(2, 2, 1);
    const Image<std::uint32_t> ids(3, 2, 1);
    const auto make = [](const std::vector<ExrChannel>& channels) { encode_exr(channels); };
    EXPECT_THROW(make({}), std::invalid_argument);
    EXPECT_THROW(make({{"Y", SampleType::Half, ImageView<const float>()}}), std::invalid_argument);
    EXPECT_THROW(make({{"", SampleType::Half, image.view()}}), std::invalid_argument);
    EXPECT_THROW(make({{"Y", SampleType::Half, image.view(), 2}}), std::invalid_argument);
    EXPECT_THROW(make({{"Y", SampleType::Uint32, image.view()}}), std::invalid_argument);
    EXPECT_THROW(make({{"Y", SampleType::Float, ids.view()}}), std::invalid_argument);
    EXPECT_THROW(
        make({{"Y", SampleType::Half, image.view()}, {"Y", SampleType::Half, image.view(), 1}}),
        std::invalid_argument);
    EXPECT_THROW(
        make({{"X", SampleType::Half, image.view()}, {"Y", SampleType::Half, other.view()}}),
        std::invalid_argument);
}

TEST(ExrEncode, RejectsNamesReservedByExr) {
    const Image<float> image(1, 1, 1);
    const ExrChannel channel{"Y", SampleType::Half, image.view()};
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

}  // namespace
}  // namespace foam::texgen
