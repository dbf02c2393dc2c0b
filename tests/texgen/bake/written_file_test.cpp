// SPDX-License-Identifier: Apache-2.0

#include "texgen/bake/written_file.h"

#include "texgen/maps/all_maps.h"

#include <gtest/gtest.h>

#include <array>
#include <optional>

namespace foam::texgen {
namespace {

MapSamples described(const char* map,
                     const MapImage& image,
                     const char* suffix,
                     const OutputOptions& output = {}) {
    return describe_samples(DrawnImage(find_map(map), {}), image, *find_format(suffix), output);
}

TEST(WrittenFile, DescribesColors) {
    const MapImage opaque = ColorPixels{Image<std::uint16_t>(1, 1, 3)};
    EXPECT_EQ(described("albedo", opaque, ".png"),
              (MapSamples{"color", "R G B", "uint8", "sRGB", "none", {}}));
    const MapImage clear = ColorPixels{Image<std::uint16_t>(1, 1, 4)};
    EXPECT_EQ(described("albedo", clear, ".png"),
              (MapSamples{"color", "R G B A", "uint8", "sRGB", "straight", {}}));
    EXPECT_EQ(described("albedo", clear, ".exr"),
              (MapSamples{"color", "R G B A", "half", "linear sRGB", "premultiplied", {}}));
    EXPECT_EQ(described("albedo", clear, ".exr", {.primaries = Primaries::AcesCg}).color_space,
              "ACEScg");
}

TEST(WrittenFile, DescribesNumbersAndIds) {
    const MapImage height = NumberPixels{Image<float>(1, 1, 1), -1.0, 3.0};
    const std::optional<std::array<double, 2>> range(std::array{-1.0, 3.0});
    EXPECT_EQ(described("height", height, ".png"),
              (MapSamples{"number", "Y", "uint16", "data", "none", range}));
    EXPECT_EQ(described("height", height, ".exr"),
              (MapSamples{"number", "Y", "float", "data", "none", range}));
    const MapImage id = IdPixels{Image<std::uint32_t>(1, 1, 1)};
    EXPECT_EQ(described("id", id, ".exr").type, "uint32");
    EXPECT_EQ(described("id", id, ".exr").kind, "id");
}

// A third channel of zeros prevents programs from reading the second channel as opacity.
TEST(WrittenFile, TwoChannelsOfCodesArePadded) {
    const MapImage motion = NumberPixels{Image<float>(1, 1, 2)};
    EXPECT_EQ(described("motion", motion, ".png").channels, "X Y 0");
    EXPECT_EQ(described("motion", motion, ".exr").channels, "X Y");
}

TEST(WrittenFile, AFormatLimitsTheBitsOfACode) {
    ImageFormat format = *find_format(".png");
    EXPECT_EQ(code_bits(DrawnImage(find_map("height"), {}), format), 16);
    format.code_bits = 8;
    EXPECT_EQ(code_bits(DrawnImage(find_map("height"), {}), format), 8);
    EXPECT_EQ(code_bits(DrawnImage(find_map("albedo"), {}), format), 8);
}

}  // namespace
}  // namespace foam::texgen
