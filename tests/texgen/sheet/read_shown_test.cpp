// SPDX-License-Identifier: Apache-2.0

#include "tests/texgen/pictures.h"
#include "tests/texgen/sheet/shown_pictures.h"
#include "tests/texgen/temporary_folder.h"
#include "texgen/image/color.h"
#include "texgen/image/exr.h"
#include "texgen/image/file_io.h"
#include "texgen/sheet/shown_frame.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <vector>

namespace foam::texgen {
namespace {

TEST(ReadShown, ShowsTheHigherHalfOf16Bits) {
    Image<std::uint16_t> image(1, 1, 1);
    image.samples()[0] = 200 * 257;
    EXPECT_EQ(codes(shown(image, "data")), (std::vector<std::uint8_t>{200, 200, 200}));
}

// A pixel of no opacity, and one that covers half of the ground.
TEST(ReadShown, LiesOnTheGround) {
    const auto image = picture(2, 1, 4, {255, 0, 0, 0, 255, 255, 255, 51});
    const double ground = srgb_to_linear(kGround / 255.0);
    const Srgb8 mixed = to_srgb8({0.2 + 0.8 * ground, 0.0, 0.0});
    EXPECT_EQ(codes(shown(image, "sRGB")),
              (std::vector<std::uint8_t>{kGround, kGround, kGround, mixed.r, mixed.r, mixed.r}));
}

// Of a range from -1 to 3: 0 lies a quarter of the way, 64 of 255; the ends hold what lies beyond.
TEST(ReadShown, ShowsNumbersOfAnExrInTheirRange) {
    const TemporaryFolder folder;
    const MapFile file{.path = folder.path() / "a.exr"};
    Image<float> numbers(4, 1, 1);
    std::ranges::copy(std::vector{-7.0F, 0.0F, 3.0F, 1e9F}, numbers.samples().begin());
    write_exr(file.path, std::vector<ExrChannel>{{"Y", SampleType::Float, numbers.view()}});
    ManifestMap map = map_of("data");
    EXPECT_THROW(read_shown(file, map), InputError);
    map.samples->range = {-1.0, 3.0};
    EXPECT_EQ(codes(read_shown(file, map)),
              (std::vector<std::uint8_t>{0, 0, 0, 64, 64, 64, 255, 255, 255, 255, 255, 255}));
}

TEST(ReadShown, RejectsOtherFormats) {
    EXPECT_THROW(read_shown({.path = "a.jpg"}, map_of("data")), InputError);
}

}  // namespace
}  // namespace foam::texgen
