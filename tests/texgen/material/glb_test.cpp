// SPDX-License-Identifier: Apache-2.0

#include "texgen/material/glb.h"

#include "tests/texgen/material/baked_material.h"
#include "texgen/image/png.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cstring>
#include <span>

namespace foam::texgen {
namespace {

std::uint32_t number_at(const Bytes& bytes, std::size_t position) {
    std::uint32_t number = 0;
    std::memcpy(&number, bytes.data() + position, sizeof number);
    return number;
}

// The parts of a file, whose layout is that of the specification of glTF 2.0.
struct Parts {
    nlohmann::json json;
    Bytes binary;

    explicit Parts(const Bytes& file) {
        EXPECT_EQ(number_at(file, 0), 0x46546C67U);
        EXPECT_EQ(number_at(file, 4), 2U);
        EXPECT_EQ(number_at(file, 8), file.size());
        const std::size_t length = number_at(file, 12);
        EXPECT_EQ(number_at(file, 16), 0x4E4F534AU);
        EXPECT_EQ(length % 4, 0U);
        json = nlohmann::json::parse(reinterpret_cast<const char*>(file.data()) + 20,
                                     reinterpret_cast<const char*>(file.data()) + 20 + length);
        EXPECT_EQ(number_at(file, 20 + length), file.size() - 28 - length);
        EXPECT_EQ(number_at(file, 24 + length), 0x004E4942U);
        binary.assign(file.begin() + static_cast<std::ptrdiff_t>(28 + length), file.end());
        EXPECT_EQ(json["buffers"][0]["byteLength"], binary.size());
    }

    Picture image(const nlohmann::json& texture) const {
        const auto& source =
            json["images"][json["textures"][texture["index"].get<std::size_t>()]["source"]
                               .get<std::size_t>()];
        const auto& view = json["bufferViews"][source["bufferView"].get<std::size_t>()];
        return decode_png(std::span(binary).subspan(view["byteOffset"].get<std::size_t>(),
                                                    view["byteLength"].get<std::size_t>()));
    }
};

Parts parts_of(const SceneMaterial& material) {
    return Parts(glb(material, preview_textures(material)));
}

TEST(Glb, ContainsTheTexturesAsPngs) {
    const TemporaryFolder folder;
    Preset preset = small_material(folder, {"albedo", "normal", "emission"});
    preset.output.pack = {"P=1-roughness,occlusion,metallic"};
    const SceneMaterial material = baked_material(preset, folder);
    const Parts parts = parts_of(material);
    const auto& written = parts.json["materials"][0];
    const auto& model = written["pbrMetallicRoughness"];
    const PreviewTextures textures = preview_textures(material);
    const auto pixels = [&](const nlohmann::json& texture) {
        return std::get<Image<std::uint8_t>>(parts.image(texture).groups.front().samples);
    };
    EXPECT_TRUE(
        std::ranges::equal(pixels(model["baseColorTexture"]).samples(), textures.color->samples()));
    EXPECT_TRUE(
        std::ranges::equal(pixels(written["normalTexture"]).samples(), textures.normal->samples()));
    EXPECT_TRUE(std::ranges::equal(pixels(written["emissiveTexture"]).samples(),
                                   textures.emission->samples()));
    EXPECT_TRUE(std::ranges::equal(pixels(written["occlusionTexture"]).samples(),
                                   textures.surface->samples()));
    EXPECT_EQ(written["occlusionTexture"], model["metallicRoughnessTexture"]);
    EXPECT_EQ(parts.json["images"].size(), 4U);
    EXPECT_EQ(model["metallicFactor"], 1.0);
    EXPECT_EQ(model["roughnessFactor"], 1.0);
    EXPECT_FALSE(written.contains("alphaMode"));
    EXPECT_TRUE(parts.image(model["baseColorTexture"]).metadata.color);
    EXPECT_FALSE(parts.image(written["normalTexture"]).metadata.color);
}

// The plane is 1 m wide per tile, and half as high as wide; texture coordinates reach 2.
TEST(Glb, ShowsTwoTilesInEachDirection) {
    const TemporaryFolder folder;
    const Parts parts = parts_of(baked_material(small_material(folder, {"albedo"}), folder));
    const auto& attributes = parts.json["meshes"][0]["primitives"][0]["attributes"];
    const auto& positions = parts.json["accessors"][attributes["POSITION"].get<std::size_t>()];
    EXPECT_EQ(positions["max"], (std::vector{1.0, 0.5, 0.0}));
    EXPECT_EQ(positions["min"], (std::vector{-1.0, -0.5, 0.0}));
    EXPECT_FALSE(attributes.contains("TANGENT"));  // only normal maps need it
    const auto& accessor = parts.json["accessors"][attributes["TEXCOORD_0"].get<std::size_t>()];
    const auto& view = parts.json["bufferViews"][accessor["bufferView"].get<std::size_t>()];
    std::array<float, 8> coordinates{};
    std::memcpy(coordinates.data(),
                parts.binary.data() + view["byteOffset"].get<std::size_t>(),
                sizeof coordinates);
    EXPECT_EQ(coordinates, (std::array<float, 8>{0, 2, 2, 2, 2, 0, 0, 0}));
    EXPECT_EQ(parts.json["samplers"][0]["wrapS"], 10497);
    const auto& model = parts.json["materials"][0]["pbrMetallicRoughness"];
    EXPECT_EQ(model["metallicFactor"], 0.0);
    EXPECT_EQ(model["roughnessFactor"], 0.5);
}

TEST(Glb, LitColorsNeedNoLight) {
    const TemporaryFolder folder;
    Preset preset = small_material(folder, {"lit", "normal"});
    preset.shape.kind = FoamKind::Patch;
    const Parts parts = parts_of(baked_material(preset, folder, {1}));
    const auto& written = parts.json["materials"][0];
    EXPECT_TRUE(written["extensions"].contains("KHR_materials_unlit"));
    EXPECT_EQ(parts.json["extensionsUsed"], std::vector<std::string>{"KHR_materials_unlit"});
    EXPECT_EQ(written["alphaMode"], "BLEND");
    EXPECT_FALSE(written.contains("normalTexture"));
    EXPECT_EQ(parts.json["images"].size(), 1U);
    EXPECT_EQ(parts.json["samplers"][0]["wrapS"], 33071);
}

TEST(Glb, AMaterialWithoutColorsIsGray) {
    const TemporaryFolder folder;
    const Parts parts = parts_of(baked_material(small_material(folder, {"height"}), folder));
    EXPECT_EQ(parts.json["materials"][0]["pbrMetallicRoughness"]["baseColorFactor"],
              (std::vector{0.5, 0.5, 0.5, 1.0}));
    EXPECT_FALSE(parts.json.contains("images"));
}

// glTF multiplies the texture by the factor.
TEST(Glb, APatchWithoutColorsIsGrayWithItsOpacity) {
    const TemporaryFolder folder;
    Preset preset = small_material(folder, {"normal", "opacity"});
    preset.shape.kind = FoamKind::Patch;
    const Parts parts = parts_of(baked_material(preset, folder, {1}));
    const auto& written = parts.json["materials"][0];
    const auto& model = written["pbrMetallicRoughness"];
    EXPECT_EQ(written["alphaMode"], "BLEND");
    EXPECT_EQ(model["baseColorFactor"], (std::vector{0.5, 0.5, 0.5, 1.0}));
    ASSERT_TRUE(model.contains("baseColorTexture"));
    EXPECT_EQ(parts.image(model["baseColorTexture"]).groups.front().channels(), 4);
}

}  // namespace
}  // namespace foam::texgen
