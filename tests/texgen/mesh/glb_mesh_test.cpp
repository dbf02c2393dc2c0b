// SPDX-License-Identifier: Apache-2.0

#include "texgen/mesh/glb_mesh.h"

#include "texgen/mesh/glb_builder.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <cstdint>
#include <cstring>

namespace foam::texgen {
namespace {

// The JSON and the binary part of a GLB file, with its layout checked.
struct GlbParts {
    nlohmann::json json;
    std::string binary;

    explicit GlbParts(const std::string& file) {
        const auto word = [&](std::size_t at) {
            std::uint32_t number = 0;
            std::memcpy(&number, file.data() + at, sizeof number);
            return number;
        };
        EXPECT_EQ(file.substr(0, 4), "glTF");
        EXPECT_EQ(word(4), 2U);
        EXPECT_EQ(word(8), file.size());
        EXPECT_EQ(file.substr(16, 4), "JSON");
        json = nlohmann::json::parse(file.substr(20, word(12)));
        binary = file.substr(28 + word(12));
        EXPECT_EQ(word(20 + word(12)), binary.size());
    }

    float number(std::size_t accessor, std::size_t index) const {
        const nlohmann::json& view = json["bufferViews"][accessor];
        float value = 0.0F;
        std::memcpy(&value,
                    binary.data() + view["byteOffset"].get<std::size_t>() + index * sizeof value,
                    sizeof value);
        return value;
    }
};

TEST(GlbMesh, IsInMetersWithYUp) {
    // z up: the point (1, 2, 3) mm. y up: (0.001, 0.003, -0.002) m.
    const Mesh mesh{{{0, 0, 0}, {1, 2, 3}, {0, 2, 0}}, {{0, 1, 2}}};
    const GlbParts parts(to_glb(mesh, "name"));
    const auto& primitive = parts.json["meshes"][0]["primitives"][0];
    const std::size_t position = primitive["attributes"]["POSITION"];
    EXPECT_EQ(parts.json["accessors"][position]["count"], 3);
    EXPECT_EQ(parts.json["accessors"][position]["min"], (std::vector<float>{0, 0, -0.002F}));
    EXPECT_EQ(parts.json["accessors"][position]["max"], (std::vector<float>{0.001F, 0.003F, 0}));
    EXPECT_EQ(parts.json["accessors"][primitive["indices"].get<std::size_t>()]["count"], 3);
    EXPECT_EQ(parts.json["nodes"][0]["name"], "name");
    // The normal of the triangle is (1, 2, 3) x (0, 2, 0) = (-6, 0, 2), and (-6, 2, 0) with y up.
    const std::size_t normal = primitive["attributes"]["NORMAL"];
    EXPECT_NEAR(parts.number(normal, 0), -6.0 / std::sqrt(40.0), 1e-6);
    EXPECT_NEAR(parts.number(normal, 1), 2.0 / std::sqrt(40.0), 1e-6);
    EXPECT_EQ(parts.number(normal, 2), 0.0F);
}

TEST(GlbBuilder, ContentIsAligned) {
    GlbBuilder builder("node");
    const std::vector<std::byte> three(3);
    EXPECT_EQ(builder.add_bytes(three), 0U);
    EXPECT_EQ(builder.add_bytes(three), 1U);
    const std::vector<std::uint16_t> corners{0, 1, 2};
    EXPECT_EQ(builder.add_corners(corners), 0U);
    builder.set_mesh("mesh", {{"indices", 0}});
    const Bytes file = builder.file();
    const GlbParts parts({reinterpret_cast<const char*>(file.data()), file.size()});
    EXPECT_EQ(parts.json["bufferViews"][1]["byteOffset"], 4);
    EXPECT_EQ(parts.json["bufferViews"][2]["byteOffset"], 8);
    EXPECT_EQ(parts.json["accessors"][0]["componentType"], 5123);
    EXPECT_EQ(parts.binary.size() % 4, 0U);
    EXPECT_EQ(parts.json["meshes"][0]["name"], "mesh");
}

}  // namespace
}  // namespace foam::texgen
