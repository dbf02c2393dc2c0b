// SPDX-License-Identifier: Apache-2.0

#include "texgen/image/picture_layers.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <string>
#include <vector>

namespace foam::texgen {
namespace {

/// Returns a picture with one group per name. Its first sample is the index of the name.
Picture picture_of(const std::vector<std::string>& names) {
    Picture picture;
    for (const std::string& name : names) {
        Image<float> image(1, 1, 1);
        image.samples()[0] = static_cast<float>(picture.groups.size());
        picture.groups.push_back({{name}, SampleType::Float, image});
    }
    picture.metadata.text = {{"Seed", "1"}};
    return picture;
}

TEST(PictureLayers, ALayerIsTheTextBeforeTheLastDot) {
    const std::vector<PictureLayer> layers =
        split_into_layers(picture_of({"normal.X", "A", "view.depth.Z", "normal.Y"}));
    ASSERT_EQ(layers.size(), 3U);
    EXPECT_EQ(layers[0].name, "");
    EXPECT_EQ(layers[1].name, "normal");
    EXPECT_EQ(layers[2].name, "view.depth");
    ASSERT_EQ(layers[1].picture.groups.size(), 2U);
    EXPECT_EQ(layers[1].picture.groups[1].names.front(), "normal.Y");
    EXPECT_EQ(std::get<Image<float>>(layers[1].picture.groups[1].samples).samples()[0], 3.0F);
    EXPECT_EQ(layers[2].picture.metadata.text.size(), 1U);
}

TEST(PictureLayers, APictureWithoutLayersIsOneLayer) {
    const std::vector<PictureLayer> layers =
        split_into_layers({{code_channels(Image<std::uint8_t>(2, 1, 3))}});
    ASSERT_EQ(layers.size(), 1U);
    EXPECT_EQ(layers[0].name, "");
    EXPECT_EQ(channels_of(layers[0].picture).size(), 3U);
}

}  // namespace
}  // namespace foam::texgen
