// SPDX-License-Identifier: Apache-2.0

#include "texgen/material/scene_material.h"

#include "core/files/file_io.h"
#include "tests/texgen/material/baked_material.h"

#include <gtest/gtest.h>

namespace foam::texgen {
namespace {

using Numbers = std::array<double, 4>;

TEST(SceneMaterial, DescribesTheImagesOfABake) {
    const TemporaryFolder folder;
    Preset preset = small_material(folder, {"albedo", "normal", "id"});
    preset.output.pack = {"P=metallic,1-height,roughness,1-occlusion"};
    preset.maps.normal.y = NormalY::Down;
    const SceneMaterial material = baked_material(preset, folder);
    EXPECT_EQ(material.id, "my_foam");
    EXPECT_EQ(material.preset, "my foam");
    EXPECT_EQ(material.plane_height, 0.5);
    EXPECT_TRUE(material.tiles);
    EXPECT_EQ(material.frames, (std::vector{1, 2}));
    ASSERT_EQ(material.images.size(), 3U);  // the map id is no part of it
    EXPECT_EQ(material.images[0].paths,
              (std::vector<std::string>{"albedo.0001.png", "albedo.0002.png"}));
    EXPECT_EQ(material.images[*material.normal].scale, (Numbers{2, -2, 2, 1}));
    EXPECT_EQ(material.images[*material.normal].bias, (Numbers{-1, 1, -1, 0}));
    EXPECT_EQ(material.images[2].scale, (Numbers{1, -1, 1, -1}));
    EXPECT_EQ(material.images[2].bias, (Numbers{0, 1, 0, 1}));
    EXPECT_EQ(material.images[2].channels, (std::vector<std::string>{"R", "G", "B", "A"}));
    EXPECT_EQ(material.occlusion->channel, 3U);
    EXPECT_EQ(material.opacity.has_value(), false);
}

// A plane of 1 m is as wide as the image, and `displacement` is a fraction of this width.
TEST(SceneMaterial, TakesDisplacementsFromTheManifest) {
    const TemporaryFolder folder;
    const Preset preset = small_material(folder, {"height"}, ".exr");
    const SceneMaterial material = baked_material(preset, folder);
    const BakedSet set = read_manifest(folder.path()).sets.back();
    ASSERT_EQ(material.displacements.size(), 2U);
    EXPECT_EQ(material.displacements[1], set.find_file("height", 2)->displacement.value());
    EXPECT_TRUE(material.has_one_displacement());
    SceneMaterial other = material;
    other.displacements[1] *= 1.001;
    EXPECT_FALSE(other.has_one_displacement());
}

TEST(SceneMaterial, NormalsOfAnExrAreNotScaled) {
    const TemporaryFolder folder;
    const SceneMaterial material =
        baked_material(small_material(folder, {"normal_dx"}, ".exr"), folder);
    EXPECT_EQ(material.images[0].scale, (Numbers{1, -1, 1, 1}));
    EXPECT_EQ(material.images[0].bias, (Numbers{0, 0, 0, 0}));
}

// Images of a patch have an opacity, and do not tile.
TEST(SceneMaterial, OfAPatchHasAnOpacity) {
    const TemporaryFolder folder;
    Preset preset = small_material(folder, {"lit", "opacity"});
    preset.shape.kind = FoamKind::Patch;
    const SceneMaterial material = baked_material(preset, folder, {1});
    EXPECT_FALSE(material.tiles);
    EXPECT_EQ(material.lit, 0U);
    ASSERT_TRUE(material.opacity);
    EXPECT_EQ(material.opacity->image, 0U);
    EXPECT_EQ(material.opacity->channel, 3U);
}

// A frame of which an earlier bake has drawn only some of the maps is left out.
TEST(SceneMaterial, HasTheFramesWithAllImages) {
    const TemporaryFolder folder;
    const Preset preset = small_material(folder, {"albedo", "height"});
    Preset albedo = preset;
    albedo.image.maps = {"albedo"};
    bake_recorded(albedo, {.frames = {3}, .threads = 1}, {});
    EXPECT_EQ(baked_material(preset, folder).frames, (std::vector{1, 2}));
    BakedSet set = read_manifest(folder.path()).sets.back();
    std::erase_if(set.files, [](const ManifestFile& file) { return file.maps[0] == "height"; });
    EXPECT_THROW(scene_material(preset, set, folder.path()), InputError);
}

}  // namespace
}  // namespace foam::texgen
