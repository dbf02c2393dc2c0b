// SPDX-License-Identifier: Apache-2.0

#include "core/files/file_io.h"
#include "tests/support/temporary_folder.h"
#include "tests/texgen/pictures.h"
#include "tests/texgen/sheet/shown_pictures.h"
#include "texgen/image/color.h"
#include "texgen/image/exr.h"
#include "texgen/sheet/display_frame.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <string>
#include <vector>

namespace foam::texgen {
namespace {

TEST(ReadDisplayFrame, ShowsTheHigherHalfOf16Bits) {
    Image<std::uint16_t> image(1, 1, 1);
    image.samples()[0] = 200 * 257;
    EXPECT_EQ(codes(shown(image, "data")), (std::vector<std::uint8_t>{200, 200, 200}));
}

// A pixel of no opacity, and one that covers a part of the background.
TEST(ReadDisplayFrame, IsCompositedOverTheBackground) {
    const auto image = picture(2, 1, 4, {255, 0, 0, 0, 255, 255, 255, 51});
    const double background = srgb_to_linear(kBackgroundGray / 255.0);
    const Srgb8 mixed = to_srgb8({0.2 + 0.8 * background, 0.0, 0.0});
    EXPECT_EQ(codes(shown(image, "sRGB", "straight")),
              (std::vector<std::uint8_t>{
                  kBackgroundGray, kBackgroundGray, kBackgroundGray, mixed.r, mixed.r, mixed.r}));
}

// The channel A of a packed image, of data or of colors, is no opacity.
TEST(ReadDisplayFrame, ShowsPackedImagesWithoutTheirChannelA) {
    const auto image = picture(1, 1, 4, {10, 244, 20, 50});
    for (const char* color_space : {"data", "sRGB"}) {
        EXPECT_EQ(codes(shown(image, color_space)), (std::vector<std::uint8_t>{10, 244, 20}));
    }
}

// Premultiplied colors, as in an EXR of a patch: 0.2 of white light, and the background.
TEST(ReadDisplayFrame, AddsTheBackgroundToPremultipliedColors) {
    const TemporaryFolder folder;
    const MapFile file{.path = folder.path() / "a.exr"};
    Image<float> fifth(1, 1, 1);
    fifth.samples()[0] = 0.2F;
    write_exr(file.path,
              std::vector<ExrChannel>{{"A", SampleType::Float, fifth.view()},
                                      {"Y", SampleType::Float, fifth.view()}});
    const double mixed = 0.2 + 0.8 * srgb_to_linear(kBackgroundGray / 255.0);
    const std::uint8_t code = to_srgb8({mixed, mixed, mixed}).r;
    EXPECT_EQ(codes(read_display_frame(file, map_of("linear sRGB", "premultiplied"))),
              (std::vector<std::uint8_t>{code, code, code}));
    const std::uint8_t opaque = to_srgb8({0.2, 0.2, 0.2}).r;
    EXPECT_EQ(codes(read_display_frame(file, map_of("linear sRGB"))),
              (std::vector<std::uint8_t>{opaque, opaque, opaque}));
}

// The range is from -1 to 3. The number 0 is a quarter of the range above its lower end, which
// gives the code 64 of 255. Numbers beyond the range are clamped to its ends.
TEST(ReadDisplayFrame, ShowsNumbersOfAnExrInTheirRange) {
    const TemporaryFolder folder;
    const MapFile file{.path = folder.path() / "a.exr"};
    Image<float> numbers(4, 1, 1);
    std::ranges::copy(std::vector{-7.0F, 0.0F, 3.0F, 1e9F}, numbers.samples().begin());
    write_exr(file.path, std::vector<ExrChannel>{{"Y", SampleType::Float, numbers.view()}});
    ManifestMap map = map_of("data");
    EXPECT_THROW(read_display_frame(file, map), InputError);
    map.samples->range = {-1.0, 3.0};
    EXPECT_EQ(codes(read_display_frame(file, map)),
              (std::vector<std::uint8_t>{0, 0, 0, 64, 64, 64, 255, 255, 255, 255, 255, 255}));
}

// Light of ACEScg is shown as sRGB: the numbers of red in ACEScg are the first column of the matrix
// of the conversion (tests/texgen/image/primaries_test.cpp).
TEST(ReadDisplayFrame, ConvertsColorsToThePrimariesOfSrgb) {
    const TemporaryFolder folder;
    const MapFile file{.path = folder.path() / "a.exr"};
    Image<float> red(1, 1, 3);
    std::ranges::copy(std::vector{0.613097F, 0.070194F, 0.020616F}, red.samples().begin());
    write_exr(file.path,
              std::vector<ExrChannel>{{"R", SampleType::Float, red.view(), 0},
                                      {"G", SampleType::Float, red.view(), 1},
                                      {"B", SampleType::Float, red.view(), 2}},
              {.color = true, .primaries = Primaries::AcesCg});
    EXPECT_EQ(codes(read_display_frame(file, map_of("ACEScg"))),
              (std::vector<std::uint8_t>{255, 0, 0}));
}

// Channels Y and A, as other programs write a gray picture with an opacity. Of Z alone nothing can
// be shown.
TEST(ReadDisplayFrame, ShowsTheChannelYAsGrayBesideOthers) {
    const TemporaryFolder folder;
    const MapFile file{.path = folder.path() / "a.exr"};
    Image<float> ones(1, 1, 1);
    ones.samples()[0] = 1.0F;
    const ExrChannel opacity{"A", SampleType::Float, ones.view()};
    write_exr(file.path, std::vector<ExrChannel>{opacity, {"Y", SampleType::Float, ones.view()}});
    EXPECT_EQ(codes(read_display_frame(file, map_of("linear sRGB"))),
              (std::vector<std::uint8_t>{255, 255, 255}));
    write_exr(file.path, std::vector<ExrChannel>{opacity, {"Z", SampleType::Float, ones.view()}});
    try {
        read_display_frame(file, map_of("linear sRGB"));
        FAIL();
    } catch (const InputError& error) {
        EXPECT_EQ(std::string(error.what()),
                  "cannot show '" + file.path.string() +
                      "': it has no channel R, X or Y of floats; its channels are A Z");
    }
}

TEST(ReadDisplayFrame, RejectsOtherFormats) {
    EXPECT_THROW(read_display_frame({.path = "a.jpg"}, map_of("data")), InputError);
}

}  // namespace
}  // namespace foam::texgen
