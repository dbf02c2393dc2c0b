// SPDX-License-Identifier: Apache-2.0

#include "texgen/image/format.h"

#include "tests/support/temporary_folder.h"
#include "tests/texgen/pictures.h"
#include "texgen/image/compare.h"
#include "texgen/image/pixel_hash.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace foam::texgen {
namespace {

/// Returns a picture of 5 x 3 pixels that the format can store.
Picture picture_for(const ImageFormat& format) {
    if (format.samples == FormatSamples::Numbers) {
        Image<float> numbers(5, 3, 3);
        float number = -1.0F;
        std::ranges::generate(numbers.samples(), [&] { return number += 0.125F; });
        return {{{{"R", "G", "B"}, SampleType::Float, numbers}}};
    }
    Image<std::uint8_t> codes(5, 3, 3);
    std::uint8_t code = 0;
    std::ranges::generate(codes.samples(), [&] { return code += 5; });
    return {{code_channels(codes)}};
}

// Encodes without block compression, which changes pixels.
constexpr EncodingOptions kLossless{.gpu = {.blocks = BlockCompression::None}};

TEST(Format, EveryFormatRoundTrips) {
    for (const ImageFormat& format : image_formats()) {
        SCOPED_TRACE(format.name);
        const Picture picture = picture_for(format);
        const Picture back = format.decode(format.encode(picture, kLossless));
        EXPECT_EQ(pixel_hash(back), pixel_hash(picture));
        EXPECT_EQ(compare(back, picture).verdict, Verdict::Same);
    }
}

TEST(Format, EveryTruncationIsAnInputError) {
    for (const ImageFormat& format : image_formats()) {
        const Bytes content = format.encode(picture_for(format), {});
        for (std::size_t size = 0; size < content.size(); ++size) {
            EXPECT_THROW(format.decode(std::span(content).first(size)), InputError)
                << format.name << " " << size;
        }
    }
}

TEST(Format, IsFoundByItsSuffix) {
    for (const ImageFormat& format : image_formats()) {
        EXPECT_EQ(find_format("folder.x/a.0001" + std::string(format.suffix))->name, format.name);
        EXPECT_NE(format_suffixes().find(format.suffix), std::string::npos);
        EXPECT_NE(format_names().find(format.name), std::string::npos);
    }
    EXPECT_EQ(find_format("a.EXR")->name, "EXR");
    EXPECT_EQ(find_format("a.jpg"), nullptr);
    EXPECT_EQ(find_format("png"), nullptr);
}

// The same picture is stored as a PNG of 8 bits, as a PNG of 16 bits and as an EXR. The code 51 of
// 255 is the number 0.2.
TEST(Format, AllAreReadAlike) {
    const TemporaryFolder folder;
    Image<std::uint8_t> coarse(1, 1, 3);
    std::ranges::copy(std::vector{0, 51, 255}, coarse.samples().begin());
    Image<std::uint16_t> fine(1, 1, 3);
    std::ranges::copy(std::vector{0, 13107, 65535}, fine.samples().begin());
    Image<float> whole(1, 1, 3);
    std::ranges::copy(std::vector{0.0F, 0.2F, 1.0F}, whole.samples().begin());
    write_png(folder.path() / "coarse.png", coarse.view());
    write_png(folder.path() / "fine.png", fine.view());
    const std::vector<ExrChannel> channels = {{"R", SampleType::Float, whole.view(), 0},
                                              {"G", SampleType::Float, whole.view(), 1},
                                              {"B", SampleType::Float, whole.view(), 2}};
    write_exr(folder.path() / "whole.exr", channels);
    const Picture a = read_picture(folder.path() / "coarse.png");
    const std::vector<PictureChannel> sorted = channels_of(a);
    EXPECT_EQ(sorted[0].name, "B");
    std::array<double, 1> green{};
    read_numbers(sorted[1], 0, green);
    EXPECT_EQ(green[0], 0.2);
    EXPECT_EQ(compare(a, read_picture(folder.path() / "fine.png")).largest, 0.0);
    EXPECT_EQ(compare(a, read_picture(folder.path() / "whole.exr")).verdict, Verdict::Same);
    EXPECT_THROW(read_picture(folder.path() / "a.jpg"), InputError);
    EXPECT_THROW(read_picture(folder.path() / "none.png"), InputError);
}

}  // namespace
}  // namespace foam::texgen
