// SPDX-License-Identifier: Apache-2.0

#include "texgen/material/usda.h"

#include "tests/texgen/material/baked_material.h"

#include <gtest/gtest.h>

namespace foam::texgen {
namespace {

#define EXPECT_CONTAINS(text, part) EXPECT_EQ(count_of(text, part), 1) << (text)

TEST(Usda, FramesAreTimeSamples) {
    const TemporaryFolder folder;
    const std::string text =
        usda_text(baked_material(small_material(folder, {"albedo"}), folder, {1, 2, 4}));
    EXPECT_TRUE(text.starts_with("#usda 1.0\n("));
    EXPECT_CONTAINS(text, "defaultPrim = \"my_foam\"");
    EXPECT_CONTAINS(text, "\n    startTimeCode = 1\n");
    EXPECT_CONTAINS(text, "\n    endTimeCode = 4\n");
    EXPECT_CONTAINS(text, "\n    timeCodesPerSecond = 30\n");
    EXPECT_CONTAINS(text,
                    "            asset inputs:file = @./albedo.0001.png@\n"
                    "            asset inputs:file.timeSamples = {\n"
                    "                1: @./albedo.0001.png@,\n"
                    "                2: @./albedo.0002.png@,\n"
                    "                4: @./albedo.0004.png@,\n"
                    "            }\n");
    EXPECT_CONTAINS(text, "sourceColorSpace = \"sRGB\"");
    EXPECT_CONTAINS(text, "wrapS = \"repeat\"");
    EXPECT_CONTAINS(text, "wrapT = \"repeat\"");
    EXPECT_CONTAINS(text,
                    "color3f inputs:diffuseColor.connect = "
                    "</my_foam/material/image_albedo.outputs:rgb>");
    EXPECT_CONTAINS(text,
                    "points = [(-0.5, -0.25, 0), (0.5, -0.25, 0), (0.5, 0.25, 0), "
                    "(-0.5, 0.25, 0)]");
}

TEST(Usda, OneFrameNeedsNoTimeSamples) {
    const TemporaryFolder folder;
    const std::string text =
        usda_text(baked_material(small_material(folder, {"albedo"}), folder, {5}));
    EXPECT_EQ(count_of(text, "timeSamples"), 0);
    EXPECT_CONTAINS(text, "@./albedo.0005.png@");
}

TEST(Usda, ChannelsOfPackedImagesAreConnected) {
    const TemporaryFolder folder;
    Preset preset = small_material(folder, {"normal"});
    preset.output.pack = {"Mask-Map=metallic,occlusion,0,1-roughness"};
    const std::string text = usda_text(baked_material(preset, folder));
    const std::string image = "= </my_foam/material/image_Mask_Map.outputs:";
    EXPECT_CONTAINS(text, "float inputs:metallic.connect " + image + "r>");
    EXPECT_CONTAINS(text, "float inputs:occlusion.connect " + image + "g>");
    EXPECT_CONTAINS(text, "float inputs:roughness.connect " + image + "a>");
    EXPECT_CONTAINS(text, "float4 inputs:scale = (1, 1, 1, -1)");
    EXPECT_CONTAINS(text, "float4 inputs:bias = (0, 0, 0, 1)");
    EXPECT_CONTAINS(text, "float4 inputs:scale = (2, 2, 2, 1)");
    EXPECT_CONTAINS(text, "float4 inputs:bias = (-1, -1, -1, 0)");
    EXPECT_CONTAINS(text, "color3f inputs:diffuseColor = (0.5, 0.5, 0.5)");
}

// The scale of heights is a sample of time only if it varies.
TEST(Usda, HeightsDisplaceTheSurface) {
    const TemporaryFolder folder;
    Preset preset = small_material(folder, {"albedo"});
    preset.output.pack = {"H:16=0,1-height,0"};
    SceneMaterial material = baked_material(preset, folder);
    material.displacements = {0.25, 0.25};
    std::string text = usda_text(material);
    EXPECT_CONTAINS(text, "inputs:scale = (1, -0.25, 1, 1)");
    EXPECT_CONTAINS(text, "inputs:bias = (0, 0.25, 0, 0)");
    EXPECT_EQ(count_of(text, "timeSamples"), 2);
    EXPECT_CONTAINS(text, "float inputs:displacement.connect");
    EXPECT_CONTAINS(text, "token outputs:displacement.connect");
    material.displacements = {0.25, 0.5};
    text = usda_text(material);
    EXPECT_CONTAINS(text, "                2: (1, -0.5, 1, 1),\n");
    EXPECT_CONTAINS(text, "                2: (0, 0.5, 0, 0),\n");
}

// Lit colors are emitted by a surface that reflects nothing.
TEST(Usda, LitColorsAreEmitted) {
    const TemporaryFolder folder;
    const std::string text =
        usda_text(baked_material(small_material(folder, {"lit"}), folder, {1}));
    EXPECT_CONTAINS(text, "color3f inputs:emissiveColor.connect");
    EXPECT_CONTAINS(text, "color3f inputs:diffuseColor = (0, 0, 0)");
    EXPECT_CONTAINS(text, "color3f inputs:specularColor = (0, 0, 0)");
}

TEST(Usda, TextsAndPathsAreEscaped) {
    const TemporaryFolder folder;
    Preset preset = small_material(folder, {"albedo"});
    preset.description = "a \"foam\" \\ of\ntwo lines";
    SceneMaterial material = baked_material(preset, folder, {1});
    material.images[0].paths[0] = "a@b.png";
    const std::string text = usda_text(material);
    EXPECT_CONTAINS(text, R"(doc = "a \"foam\" \\ of\ntwo lines")");
    EXPECT_CONTAINS(text, "file = @@@./a@b.png@@@\n");
}

}  // namespace
}  // namespace foam::texgen
