// SPDX-License-Identifier: Apache-2.0

#include "texgen/maps/drawn_image.h"

#include "texgen/maps/all_maps.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace foam::texgen {
namespace {

TEST(DrawnImage, OfAMapHasItsTraits) {
    const DrawnImage image(find_map("height"), {});
    EXPECT_EQ(image.name(), "height");
    EXPECT_EQ(image.map(), &find_map("height"));
    EXPECT_EQ(image.sources().size(), 1U);
    EXPECT_TRUE(image.packed_channels().empty());
    EXPECT_FALSE(image.packs_colors());
    EXPECT_EQ(DrawnImage(find_map("normal_dx"), {}).note({}), find_map("normal_dx").note({}));
}

// The channels of an EXR have these names.
TEST(DrawnImage, OfPressureWithAColorMapHasTheChannelsOfColors) {
    MapOptions options;
    EXPECT_EQ(DrawnImage(find_map("pressure"), options).traits().channels, "Y");
    options.pressure.colormap = "viridis";
    const DrawnImage colored(find_map("pressure"), options);
    EXPECT_EQ(colored.traits().channels, "R G B");
    EXPECT_EQ(colored.name(), "pressure");
}

TEST(DrawnImage, OfAPackingHasTraitsOfItsOwn) {
    const DrawnImage first(parse_packing("HR:16=height,roughness,0.5,1-height"));
    const DrawnImage image = first;  // the traits stay valid in a copy
    EXPECT_EQ(image.name(), "HR");
    EXPECT_EQ(image.map(), nullptr);
    EXPECT_EQ(image.sources().size(), 2U);
    EXPECT_EQ(image.traits().channels, "R G B A");
    EXPECT_EQ(image.traits().png_bits, 16);
    EXPECT_EQ(image.traits().kind, MapKind::Number);
    EXPECT_TRUE(image.traits().full_key.empty());
    EXPECT_EQ(image.packed_channels(),
              (std::vector<std::string>{"height", "roughness", "0.5", "1-height"}));
}

TEST(DrawnImage, KnowsTheChannelsWithARange) {
    const DrawnImage packed(parse_packing("P=roughness,1-height,motion.Y"));
    EXPECT_EQ(packed.ranged_channels(), (std::vector<std::size_t>{1, 2}));
    EXPECT_EQ(packed.range_keys(),
              (std::vector<std::string_view>{"height.full", "motion.multiplier"}));
    EXPECT_EQ(packed.packed_channel(1)->map, &find_map("height"));
    EXPECT_TRUE(packed.packed_channel(1)->inverted);
    EXPECT_EQ(packed.packed_channel(3), nullptr);
    const DrawnImage motion(find_map("motion"), {});
    EXPECT_EQ(motion.ranged_channels(), (std::vector<std::size_t>{0, 1}));
    EXPECT_EQ(motion.packed_channel(0), nullptr);
    EXPECT_TRUE(DrawnImage(find_map("normal"), {}).ranged_channels().empty());
}

TEST(DrawnImage, ThePackedChannelsAreNotedWithTheirRanges) {
    MapOptions options;
    options.height.full = {0.8, false};
    EXPECT_EQ(DrawnImage(parse_packing("X=height,roughness,normal_dx.X")).note(options),
              "R: height with height.full = 0.8; G: roughness; B: normal_dx.X; " +
                  find_map("normal_dx").note(options));
}

}  // namespace
}  // namespace foam::texgen
