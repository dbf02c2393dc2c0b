// SPDX-License-Identifier: Apache-2.0

#include "texgen/material/materialx.h"

#include "tests/texgen/material/baked_material.h"

#include <gtest/gtest.h>

namespace foam::texgen {
namespace {

#define EXPECT_CONTAINS(text, part) EXPECT_EQ(count_of(text, part), 1) << (text)

TEST(MaterialX, ShowsTheFirstFrame) {
    const TemporaryFolder folder;
    const std::string text =
        materialx_text(baked_material(small_material(folder, {"albedo", "roughness"}), folder));
    EXPECT_CONTAINS(text, "<materialx version=\"1.38\" colorspace=\"lin_rec709\">");
    EXPECT_CONTAINS(text, "frame 1, the first of 2 frames");
    EXPECT_CONTAINS(text,
                    "<tiledimage name=\"image_albedo\" type=\"color3\">\n"
                    "      <input name=\"file\" type=\"filename\" value=\"albedo.0001.png\" "
                    "colorspace=\"srgb_texture\"/>\n"
                    "    </tiledimage>");
    EXPECT_CONTAINS(text,
                    "<tiledimage name=\"image_roughness\" type=\"float\">\n"
                    "      <input name=\"file\" type=\"filename\" value=\"roughness.0001.png\"/>");
    EXPECT_CONTAINS(
        text, "<output name=\"specular_roughness\" type=\"float\" nodename=\"image_roughness\"/>");
    EXPECT_CONTAINS(text,
                    "<input name=\"specular_roughness\" type=\"float\" nodegraph=\"images\" "
                    "output=\"specular_roughness\"/>");
    EXPECT_CONTAINS(text, "<surfacematerial name=\"M_my_foam\" type=\"material\">");
    EXPECT_EQ(count_of(text, "displacementshader"), 0);
}

TEST(MaterialX, TakesChannelsOutOfPackedImages) {
    const TemporaryFolder folder;
    Preset preset = small_material(folder, {"emission"});
    preset.output.pack = {"C=albedo.R,albedo.G,albedo.B,1-roughness"};
    const std::string text = materialx_text(baked_material(preset, folder, {1}));
    EXPECT_CONTAINS(text, "<tiledimage name=\"image_C\" type=\"color4\">");
    EXPECT_CONTAINS(text,
                    "<convert name=\"image_C_rgb\" type=\"color3\">\n"
                    "      <input name=\"in\" type=\"color4\" nodename=\"image_C\"/>");
    EXPECT_CONTAINS(text,
                    "<extract name=\"image_C_3\" type=\"float\">\n"
                    "      <input name=\"in\" type=\"color4\" nodename=\"image_C\"/>\n"
                    "      <input name=\"index\" type=\"integer\" value=\"3\"/>");
    EXPECT_CONTAINS(text, "<invert name=\"image_C_3_inverted\" type=\"float\">");
    EXPECT_CONTAINS(
        text,
        "<output name=\"specular_roughness\" type=\"float\" nodename=\"image_C_3_inverted\"/>");
    EXPECT_CONTAINS(text, "<input name=\"emission\" type=\"float\" value=\"1\"/>");
    EXPECT_EQ(count_of(text, "<!--"), 0);  // there is only one frame
}

// The colors of the map albedo and the image of the packing would both be image_albedo_rgb, and
// image_albedo_rgb_2 is the third channel of the packing.
TEST(MaterialX, NodesHaveDifferentNames) {
    const TemporaryFolder folder;
    Preset preset = small_material(folder, {"albedo"});
    preset.shape.kind = FoamKind::Patch;
    preset.output.pack = {"albedo_rgb=roughness,metallic,occlusion"};
    const std::string text = materialx_text(baked_material(preset, folder, {1}));
    EXPECT_CONTAINS(text, "name=\"image_albedo_rgb\" type=\"vector3\">");
    EXPECT_CONTAINS(text, "<extract name=\"image_albedo_rgb_2\" type=\"float\">");
    EXPECT_CONTAINS(text, "<convert name=\"image_albedo_rgb_3\" type=\"color3\">");
    EXPECT_CONTAINS(
        text, "<output name=\"base_color\" type=\"color3\" nodename=\"image_albedo_rgb_3\"/>");
    EXPECT_EQ(count_of(text, " name=\"image_albedo_rgb\""), 1);
    EXPECT_EQ(count_of(text, " name=\"image_albedo_rgb_2\""), 1);
}

// The codes of y are c. A normalmap expects 1 - c of normals whose y is down.
TEST(MaterialX, NormalsWhoseYIsDownAreFlipped) {
    const TemporaryFolder folder;
    const std::string down =
        materialx_text(baked_material(small_material(folder, {"normal_dx"}), folder));
    EXPECT_CONTAINS(down, "<input name=\"in2\" type=\"vector3\" value=\"1, -1, 1\"/>");
    EXPECT_CONTAINS(down, "<input name=\"in2\" type=\"vector3\" value=\"0, 1, 0\"/>");
    const TemporaryFolder other;
    const std::string up = materialx_text(baked_material(small_material(other, {"normal"}), other));
    EXPECT_CONTAINS(up, "<input name=\"in\" type=\"vector3\" nodename=\"image_normal\"/>");
    EXPECT_EQ(count_of(up, "multiply"), 0);
}

// A normal n in an EXR becomes (n + 1) / 2.
TEST(MaterialX, NormalsOfAnExrAreEncoded) {
    const TemporaryFolder folder;
    const std::string text =
        materialx_text(baked_material(small_material(folder, {"normal"}, ".exr"), folder));
    EXPECT_CONTAINS(
        text, "<input name=\"in2\" type=\"vector3\" value=\"0.5, 0.5, 0.5\"/>\n    </multiply>");
    EXPECT_CONTAINS(text,
                    "<input name=\"in2\" type=\"vector3\" value=\"0.5, 0.5, 0.5\"/>\n    </add>");
}

TEST(MaterialX, HeightsDisplaceTheSurface) {
    const TemporaryFolder folder;
    SceneMaterial material = baked_material(small_material(folder, {"height"}), folder);
    material.displacements = {0.25, 0.5};
    const std::string text = materialx_text(material);
    EXPECT_CONTAINS(text, "<input name=\"scale\" type=\"float\" value=\"0.25\"/>");
    EXPECT_CONTAINS(text,
                    "<input name=\"displacementshader\" type=\"displacementshader\" "
                    "nodename=\"displacement\"/>");
    EXPECT_CONTAINS(text, "<input name=\"base_color\" type=\"color3\" value=\"0.5, 0.5, 0.5\"/>");
}

// A patch does not repeat, and its colors have an opacity.
TEST(MaterialX, OfAPatchIsTransparentAroundIt) {
    const TemporaryFolder folder;
    Preset preset = small_material(folder, {"lit"});
    preset.shape.kind = FoamKind::Patch;
    const std::string text = materialx_text(baked_material(preset, folder, {1}));
    EXPECT_CONTAINS(text, "<image name=\"image_lit\" type=\"color4\">");
    EXPECT_CONTAINS(text, "<input name=\"uaddressmode\" type=\"string\" value=\"clamp\"/>");
    EXPECT_CONTAINS(text, "<output name=\"opacity\" type=\"color3\"");
    EXPECT_CONTAINS(text, "<input name=\"base\" type=\"float\" value=\"0\"/>");
    EXPECT_CONTAINS(text, "<input name=\"specular\" type=\"float\" value=\"0\"/>");
}

// The colors of a patch in an EXR are multiplied by the opacity.
TEST(MaterialX, PremultipliedColorsAreDividedByTheirOpacity) {
    const TemporaryFolder folder;
    Preset preset = small_material(folder, {"albedo"}, ".exr");
    preset.shape.kind = FoamKind::Patch;
    const std::string text = materialx_text(baked_material(preset, folder, {1}));
    EXPECT_CONTAINS(text,
                    "<max name=\"image_albedo_3_positive\" type=\"float\">\n"
                    "      <input name=\"in1\" type=\"float\" nodename=\"image_albedo_3\"/>\n"
                    "      <input name=\"in2\" type=\"float\" value=\"0.000001\"/>");
    EXPECT_CONTAINS(
        text,
        "<divide name=\"image_albedo_rgb_straight\" type=\"color3\">\n"
        "      <input name=\"in1\" type=\"color3\" nodename=\"image_albedo_rgb\"/>\n"
        "      <input name=\"in2\" type=\"float\" nodename=\"image_albedo_3_positive\"/>");
    EXPECT_CONTAINS(text,
                    "<output name=\"base_color\" type=\"color3\" "
                    "nodename=\"image_albedo_rgb_straight\"/>");
    const TemporaryFolder straight;
    preset.output.pattern = (straight.path() / "{map}.####.png").string();
    EXPECT_EQ(count_of(materialx_text(baked_material(preset, straight, {1})), "divide"), 0);
}

}  // namespace
}  // namespace foam::texgen
