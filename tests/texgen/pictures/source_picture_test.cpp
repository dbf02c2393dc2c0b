// SPDX-License-Identifier: Apache-2.0

#include "texgen/pictures/source_picture.h"

#include "core/files/file_io.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace foam::texgen {
namespace {

Picture codes(int channels, const std::vector<std::uint8_t>& samples) {
    Image<std::uint8_t> image(static_cast<int>(samples.size()) / channels, 1, channels);
    std::ranges::copy(samples, image.samples().begin());
    return {{code_channels(std::move(image))}};
}

// The sRGB code 188 is 0.5029 of full light (IEC 61966-2-1).
TEST(SourcePicture, CodesAreSrgb) {
    const SourcePicture picture = source_picture_of(codes(3, {255, 188, 0}), "x.png");
    const SourcePixel pixel = pixel_of(picture, 0, 0);
    EXPECT_NEAR(pixel.color.r, 1.0, 1e-4);
    EXPECT_NEAR(pixel.color.g, 0.5029, 1e-4);
    EXPECT_EQ(pixel.color.b, 0.0);
    EXPECT_EQ(pixel.opacity, 1.0);
}

TEST(SourcePicture, OneOrTwoChannelsAreGray) {
    const SourcePixel gray = pixel_of(source_picture_of(codes(1, {255}), "x.png"), 0, 0);
    EXPECT_EQ(gray.color, (LinearRgb{1.0, 1.0, 1.0}));
    const SourcePixel clear = pixel_of(source_picture_of(codes(2, {0, 51}), "x.png"), 0, 0);
    EXPECT_EQ(clear.color, (LinearRgb{0.0, 0.0, 0.0}));
    EXPECT_NEAR(clear.opacity, 0.2, 1e-4);
    EXPECT_NEAR(color_on_white(clear).g, 0.8, 1e-4);
}

// Numbers are premultiplied linear light: 0.25 of light at an opacity of 0.5 is half of white.
TEST(SourcePicture, NumbersArePremultipliedLight) {
    Image<float> rgba(2, 1, 4);
    const std::vector<float> samples{0.25F, 0.0F, 3.0F, 0.5F, 0.5F, 0.5F, 0.5F, 0.0F};
    std::ranges::copy(samples, rgba.samples().begin());
    const Picture picture{{{{"R", "G", "B", "A"}, SampleType::Half, std::move(rgba)}}};
    const SourcePicture source = source_picture_of(picture, "x.exr");
    const SourcePixel left = pixel_of(source, 0, 0);
    EXPECT_NEAR(left.color.r, 0.5, 1e-4);
    EXPECT_EQ(left.color.g, 0.0);
    EXPECT_EQ(left.color.b, 1.0);  // clamped
    EXPECT_EQ(pixel_of(source, 1, 0).opacity, 0.0);
}

TEST(SourcePicture, RejectsPicturesWithoutColors) {
    const Picture picture{{{{"id.X", "id.Z"}, SampleType::Float, Image<float>(1, 1, 2)}}};
    try {
        source_picture_of(picture, "ids.exr");
        FAIL();
    } catch (const InputError& error) {
        EXPECT_EQ(std::string(error.what()),
                  "cannot use 'ids.exr': it has neither the channel Y nor the channels R, G and B");
    }
}

TEST(SourcePicture, LuminanceHasTheWeightsOfBt709) {
    EXPECT_NEAR(luminance_of({1.0, 1.0, 1.0}), 1.0, 1e-12);
    EXPECT_NEAR(luminance_of({0.0, 1.0, 0.0}), 0.7152, 1e-12);
    EXPECT_EQ(luminance_of({0.0, 0.0, 0.0}), 0.0);
}

}  // namespace
}  // namespace foam::texgen
