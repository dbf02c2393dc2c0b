// SPDX-License-Identifier: Apache-2.0

#include "texgen/material/scene_files.h"

#include "core/files/file_io.h"
#include "tests/texgen/material/baked_material.h"
#include "texgen/image/pixel_hash.h"

#include <gtest/gtest.h>

#include <stdexcept>

namespace foam::texgen {
namespace {

std::string fault_of(const Preset& preset) {
    try {
        check_scenes(preset);
        return "no error";
    } catch (const std::invalid_argument& error) {
        return error.what();
    }
}

std::string content_of(const std::filesystem::path& path) {
    const Bytes bytes = read_file(path, kImageInput);
    return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

TEST(SceneFiles, AreWrittenBesideTheManifestAndListedInIt) {
    const TemporaryFolder folder;
    Preset preset = small_material(folder, {"albedo"});
    preset.output.scene = {"gltf", "usda", "mtlx"};
    bake_recorded(preset, {.frames = {1}, .threads = 1}, {});
    const std::vector<std::filesystem::path> paths = write_scenes(preset);
    const std::vector<std::string> names{"my foam.glb", "my foam.usda", "my foam.mtlx"};
    const BakedSet set = read_manifest(folder.path()).sets.back();
    ASSERT_EQ(paths.size(), 3U);
    ASSERT_EQ(set.scenes.size(), 3U);
    for (std::size_t k = 0; k < 3; ++k) {
        EXPECT_EQ(paths[k], folder.path() / names[k]);
        const std::string content = content_of(paths[k]);
        EXPECT_EQ(
            set.scenes[k],
            (ManifestScene{names[k], preset.output.scene[k], content.size(), text_hash(content)}));
    }
}

// The key output.scene does not change images, so a bake with it belongs to the same set.
TEST(SceneFiles, BelongToTheSetOfABakeWithoutThem) {
    const TemporaryFolder folder;
    Preset preset = small_material(folder, {"albedo"});
    bake_recorded(preset, {.frames = {1}, .threads = 1}, {});
    preset.output.scene = {"usda"};
    const BakeSummary summary =
        bake_recorded(preset, {.frames = {1, 2}, .threads = 1}, {}, {.resume = Resume::Yes});
    EXPECT_EQ(summary.kept, 1);
    write_scenes(preset);
    write_scenes(preset);
    const Manifest manifest = read_manifest(folder.path());
    ASSERT_EQ(manifest.sets.size(), 1U);
    EXPECT_EQ(manifest.sets.front().scenes.size(), 1U);
    EXPECT_NE(content_of(folder.path() / "my foam.usda").find("endTimeCode = 2"),
              std::string::npos);
}

TEST(SceneFiles, NeedImages) {
    const TemporaryFolder folder;
    Preset preset = small_material(folder, {"albedo", "height"});
    for (const char* const pattern : {"x.####.svg", "{map}.####.csv", "{map}.####.stl"}) {
        preset.output.pattern = pattern;
        preset.output.scene = {"gltf"};
        EXPECT_EQ(fault_of(preset),
                  "output.scene needs images, but output.pattern is '" + std::string(pattern) +
                      "'; set output.scene to [] for no scene");
    }
}

TEST(SceneFiles, NeedFilesThatAFormatCanReferTo) {
    const TemporaryFolder folder;
    Preset preset = small_material(folder, {"albedo", "height"});
    preset.output.scene = {"gltf", "usda"};
    EXPECT_EQ(fault_of(preset), "no error");
    preset.output.pattern = "{map}.####.exr";
    EXPECT_EQ(fault_of(preset), "no error");
    for (const char* const pattern : {"x.####.exr", "{map}.####.dds", "{map}.####.ktx2"}) {
        preset.output.pattern = pattern;
        preset.output.scene = {"gltf", "mtlx"};
        EXPECT_EQ(fault_of(preset),
                  "output.scene = \"mtlx\" needs PNG files, or EXR files with {map} in their "
                  "names, but output.pattern is '" +
                      std::string(pattern) + "'; a scene of the format gltf is possible");
        preset.output.scene = {"gltf"};
        EXPECT_EQ(fault_of(preset), "no error");
    }
}

// The textures of OpenUSD's preview surface have the primaries of sRGB.
TEST(SceneFiles, OfOpenUsdCannotReferToColorsOfAcesCg) {
    const TemporaryFolder folder;
    Preset preset = small_material(folder, {"albedo", "height"});
    preset.output.pattern = "{map}.####.exr";
    preset.output.primaries = Primaries::AcesCg;
    preset.output.scene = {"mtlx", "gltf"};
    EXPECT_EQ(fault_of(preset), "no error");
    preset.output.scene = {"usda"};
    EXPECT_NE(fault_of(preset).find("a scene of the format mtlx or gltf is possible"),
              std::string::npos);
}

// A UsdPreviewSurface would multiply these colors by the opacity again.
TEST(SceneFiles, OfOpenUsdCannotReferToPremultipliedColors) {
    const TemporaryFolder folder;
    Preset preset = small_material(folder, {"albedo", "opacity"}, ".exr");
    preset.output.scene = {"usda"};
    EXPECT_EQ(fault_of(preset), "no error");
    preset.shape.kind = FoamKind::Patch;
    EXPECT_NE(fault_of(preset).find("cannot refer to the colors of a patch in EXR files"),
              std::string::npos);
    preset.image.maps = {"normal", "opacity"};
    EXPECT_EQ(fault_of(preset), "no error");
    preset.image.maps = {"lit"};
    preset.output.scene = {"mtlx", "gltf"};
    EXPECT_EQ(fault_of(preset), "no error");
    preset.output.scene = {"usda"};
    preset.output.pattern = "{map}.####.png";
    EXPECT_EQ(fault_of(preset), "no error");
}

TEST(SceneFiles, NeedAMapOfAMaterial) {
    const TemporaryFolder folder;
    Preset preset = small_material(folder, {"id", "motion"});
    EXPECT_EQ(fault_of(preset), "no error");
    preset.output.scene = {"gltf"};
    EXPECT_EQ(fault_of(preset),
              "output.scene needs a map of a material, such as albedo, lit, normal, height, "
              "roughness, metallic, occlusion or emission, but image.maps has only id, motion; set "
              "output.scene "
              "to [] for no scene");
}

}  // namespace
}  // namespace foam::texgen
