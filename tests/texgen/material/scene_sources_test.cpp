// SPDX-License-Identifier: Apache-2.0

#include "texgen/material/scene_sources.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace foam::texgen {
namespace {

using Names = std::vector<std::string>;

Preset preset_of(Names maps, Names pack = {}) {
    Preset preset;
    preset.image.maps = std::move(maps);
    preset.output.pack = std::move(pack);
    return preset;
}

TEST(SceneSources, MapsArePreferredToPackings) {
    const SceneSources sources =
        scene_sources(preset_of({"height", "albedo", "roughness", "emission"},
                                {"P=metallic,1-occlusion,roughness,1-height", "Q=metallic,0,1"}));
    EXPECT_EQ(sources.base_color, 1U);
    EXPECT_EQ(sources.lit, std::nullopt);
    EXPECT_EQ(sources.emission, 3U);
    EXPECT_EQ(sources.height, SceneSource{.image = 0});
    EXPECT_EQ(sources.roughness, SceneSource{.image = 2});
    EXPECT_EQ(sources.metallic, (SceneSource{.image = 4, .channel = 0}));
    EXPECT_EQ(sources.occlusion, (SceneSource{.image = 4, .channel = 1, .inverted = true}));
    EXPECT_EQ(sources.opacity, std::nullopt);
}

// The base color is the map that profiles call albedo, or a packing of its colors.
TEST(SceneSources, FindsTheBaseColor) {
    EXPECT_EQ(scene_sources(preset_of({"lit", "thin_film", "albedo"})).base_color, 2U);
    Preset film = preset_of({"lit", "albedo", "thin_film"});
    film.maps.lit.colors = LitColors::ThinFilm;
    EXPECT_EQ(scene_sources(film).base_color, 2U);
    const SceneSources packed =
        scene_sources(preset_of({"height"}, {"C=albedo.R,albedo.G,albedo.B,1-roughness"}));
    EXPECT_EQ(packed.base_color, 1U);
    EXPECT_EQ(packed.roughness, (SceneSource{.image = 1, .channel = 3, .inverted = true}));
    const SceneSources swapped =
        scene_sources(preset_of({"height"}, {"C=albedo.B,albedo.G,albedo.R"}));
    EXPECT_EQ(swapped.base_color, std::nullopt);
}

// Lit colors contain the emission.
TEST(SceneSources, LitIsUsedIfThereIsNoOtherColor) {
    const SceneSources sources = scene_sources(preset_of({"emission", "lit", "normal"}));
    EXPECT_EQ(sources.base_color, std::nullopt);
    EXPECT_EQ(sources.lit, 1U);
    EXPECT_EQ(sources.emission, std::nullopt);
    EXPECT_EQ(sources.normal, 2U);
}

TEST(SceneSources, NormalsWhoseYIsUpArePreferred) {
    const auto normal = [](Names maps, NormalY y) {
        Preset preset = preset_of(maps);
        preset.maps.normal.y = y;
        const SceneSources sources = scene_sources(preset);
        return maps.at(sources.normal.value()) + (sources.is_normal_down ? " down" : " up");
    };
    EXPECT_EQ(normal({"normal_gl", "normal"}, NormalY::Up), "normal up");
    EXPECT_EQ(normal({"normal", "normal_dx", "normal_gl"}, NormalY::Down), "normal_gl up");
    EXPECT_EQ(normal({"normal_dx", "normal"}, NormalY::Down), "normal down");
    EXPECT_EQ(normal({"normal_dx", "normal"}, NormalY::Up), "normal up");
    EXPECT_EQ(normal({"normal_dx"}, NormalY::Up), "normal_dx down");
    EXPECT_EQ(scene_sources(preset_of({"albedo"})).normal, std::nullopt);
}

TEST(SceneSources, IsEmptyWithoutAMapOfAMaterial) {
    EXPECT_TRUE(scene_sources(preset_of({"id", "motion"}, {"P=pressure,0,1"})).is_empty());
    EXPECT_FALSE(scene_sources(preset_of({"id"}, {"P=pressure,0,1-height"})).is_empty());
}

}  // namespace
}  // namespace foam::texgen
