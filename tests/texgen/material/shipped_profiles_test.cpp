// SPDX-License-Identifier: Apache-2.0

#include "texgen/material/shipped_profiles.h"

#include "texgen/maps/normal.h"
#include "texgen/material/profile.h"
#include "texgen/preset/drawn_images.h"
#include "texgen/preset/load_preset.h"
#include "texgen/preset/preset_io.h"
#include "texgen/preset/shipped_presets.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace foam::texgen {
namespace {

Preset with_profile(const std::string& preset, const std::string& profile) {
    Preset loaded = load_preset(preset);
    assign(loaded, assignments_for(load_profile(profile), loaded));
    return loaded;
}

// Returns the file names of the images of frame 1, without folder and suffix.
std::vector<std::string> file_names(const Preset& preset) {
    std::vector<std::string> words;
    for (const DrawnImage& image : drawn_images(preset)) {
        words.push_back(file_word(preset, image.name()));
    }
    return words;
}

using Names = std::vector<std::string>;

TEST(ShippedProfiles, AllAreValidForAllPresets) {
    for (const ShippedProfile& profile : shipped_profiles()) {
        EXPECT_FALSE(load_profile(std::string(profile.name)).description.empty()) << profile.name;
        for (const ShippedPreset& preset : shipped_presets()) {
            const Preset both = with_profile(std::string(preset.name), std::string(profile.name));
            EXPECT_NO_THROW(check_file_words(both)) << profile.name << " " << preset.name;
        }
    }
}

// The layouts that the documents of the engines give.
TEST(ShippedProfiles, HaveTheLayoutsOfTheirEngines) {
    const Preset unreal = with_profile("lava", "unreal");
    EXPECT_EQ(file_names(unreal), (Names{"BC", "N", "H", "E", "ORM"}));
    EXPECT_EQ(unreal.output.pack, (Names{"ORM=occlusion,roughness,metallic"}));
    EXPECT_EQ(unreal.maps.normal.y, NormalY::Down);

    const Preset hdrp = with_profile("lava", "unity-hdrp");
    EXPECT_EQ(file_names(hdrp), (Names{"BaseColor", "Normal", "Height", "Emission", "MaskMap"}));
    EXPECT_EQ(hdrp.output.pack, (Names{"MaskMap=metallic,occlusion,0,1-roughness"}));
    EXPECT_EQ(hdrp.maps.normal.y, NormalY::Up);

    const Preset urp = with_profile("lava", "unity-urp");
    EXPECT_EQ(
        file_names(urp),
        (Names{"BaseMap", "Normal", "Occlusion", "Height", "Emission", "MetallicSmoothness"}));
    EXPECT_EQ(urp.output.pack,
              (Names{"MetallicSmoothness=metallic,metallic,metallic,1-roughness"}));

    const Preset godot = with_profile("lava", "godot");
    EXPECT_EQ(file_names(godot), (Names{"albedo", "normal", "height", "emission", "orm"}));
    EXPECT_EQ(godot.output.pack, (Names{"orm=occlusion,roughness,metallic"}));

    const Preset gltf = with_profile("lava", "gltf");
    EXPECT_EQ(file_names(gltf),
              (Names{"baseColor", "normal", "emissive", "occlusionRoughnessMetallic"}));
    EXPECT_EQ(gltf.output.pack, (Names{"occlusionRoughnessMetallic=occlusion,roughness,metallic"}));
    EXPECT_EQ(gltf.output.scene, Names{"gltf"});

    const Preset blender = with_profile("lava", "blender");
    EXPECT_EQ(
        file_names(blender),
        (Names{"albedo", "normal", "height", "roughness", "metallic", "occlusion", "emission"}));
    EXPECT_TRUE(blender.output.pack.empty());
}

TEST(ShippedProfiles, AnUnknownNameIsRejectedWithAllNames) {
    try {
        find_shipped_profile("unreel");
        FAIL();
    } catch (const PresetError& error) {
        EXPECT_EQ(std::string(error.what()),
                  "profile 'unreel': must be a .toml file or one of unreal, unity-hdrp, unity-urp, "
                  "godot, gltf, blender; did you mean 'unreal'?");
    }
}

}  // namespace
}  // namespace foam::texgen
