// SPDX-License-Identifier: Apache-2.0

#include "texgen/material/glb.h"

#include "texgen/image/png.h"
#include "texgen/mesh/glb_builder.h"

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace foam::texgen {

namespace {

// Numbers of the glTF 2.0 specification.
constexpr int kLinear = 9729;
constexpr int kLinearMipmapLinear = 9987;
constexpr int kRepeat = 10497;
constexpr int kClampToEdge = 33071;

constexpr double kGray = 0.5;       // base color of a material without colors
constexpr double kRoughness = 0.5;  // roughness of a material without a map of the roughness

// Returns the components of a vector four times: once for each corner of the plane.
std::vector<float> at_all_corners(const std::vector<float>& vector) {
    std::vector<float> all;
    for (int corner = 0; corner < 4; ++corner) {
        all.insert(all.end(), vector.begin(), vector.end());
    }
    return all;
}

// Writes the plane and its material.
class GlbWriter {
  public:
    GlbWriter(const SceneMaterial& material, const PreviewTextures& textures)
        : material_(material), textures_(textures), builder_(material.preset) {}

    Bytes write() {
        write_material();
        write_mesh();
        return builder_.file();
    }

  private:
    // Texture coordinates begin at the top left corner of an image. The tangent points to the
    // right and, with w = 1, the bitangent points up.
    void write_mesh() {
        const float tiles = material_.tiles ? 2.0F : 1.0F;
        const float x = tiles * static_cast<float>(kPlaneWidth / 2.0);
        const float y = tiles * static_cast<float>(material_.plane_height / 2.0);
        const std::array positions{-x, -y, 0.0F, x, -y, 0.0F, x, y, 0.0F, -x, y, 0.0F};
        const std::array coordinates{0.0F, tiles, tiles, tiles, tiles, 0.0F, 0.0F, 0.0F};
        Json attributes;
        attributes["POSITION"] =
            builder_.add_vectors(positions, 3, {{"min", {-x, -y, 0.0F}}, {"max", {x, y, 0.0F}}});
        attributes["NORMAL"] = builder_.add_vectors(at_all_corners({0, 0, 1}), 3, Json::object());
        if (textures_.normal) {
            attributes["TANGENT"] =
                builder_.add_vectors(at_all_corners({1, 0, 0, 1}), 4, Json::object());
        }
        if (builder_.json.contains("textures")) {
            attributes["TEXCOORD_0"] = builder_.add_vectors(coordinates, 2, Json::object());
        }
        const std::array<std::uint16_t, 6> corners{0, 1, 2, 0, 2, 3};
        builder_.set_mesh(
            material_.preset,
            {{"attributes", attributes},
             {"indices", builder_.add_corners(std::span<const std::uint16_t>(corners))},
             {"material", 0}});
    }

    Json add_texture(const Image<std::uint8_t>& pixels, const char* name, bool is_color) {
        if (!builder_.json.contains("samplers")) {
            const int wrap = material_.tiles ? kRepeat : kClampToEdge;
            builder_.json["samplers"] = Json::array({{{"magFilter", kLinear},
                                                      {"minFilter", kLinearMipmapLinear},
                                                      {"wrapS", wrap},
                                                      {"wrapT", wrap}}});
        }
        const Bytes png = encode_png(pixels.view(), {.color = is_color}, {.filter = PngFilter::Up});
        builder_.json["images"].push_back(
            {{"name", name}, {"mimeType", "image/png"}, {"bufferView", builder_.add_bytes(png)}});
        builder_.json["textures"].push_back(
            {{"sampler", 0}, {"source", builder_.json["images"].size() - 1}});
        return {{"index", builder_.json["textures"].size() - 1}};
    }

    Json metallic_roughness() {
        Json model;
        if (textures_.color) {
            model["baseColorTexture"] = add_texture(*textures_.color, "baseColor", true);
        }
        if (!material_.base_color && !material_.lit) {
            model["baseColorFactor"] = {kGray, kGray, kGray, 1.0};
        }
        model["metallicFactor"] = material_.metallic ? 1.0 : 0.0;
        model["roughnessFactor"] = material_.roughness || material_.lit ? 1.0 : kRoughness;
        return model;
    }

    void write_material() {
        Json material{{"name", material_.preset},
                      {"pbrMetallicRoughness", metallic_roughness()},
                      {"doubleSided", true}};
        if (material_.opacity) {
            material["alphaMode"] = "BLEND";
        }
        if (material_.lit) {
            material["extensions"]["KHR_materials_unlit"] = Json::object();
            builder_.json["extensionsUsed"] = {"KHR_materials_unlit"};
        } else {
            write_details(material);
        }
        builder_.json["materials"] = Json::array({material});
    }

    void write_details(Json& material) {
        if (textures_.normal) {
            material["normalTexture"] = add_texture(*textures_.normal, "normal", false);
        }
        if (textures_.surface) {
            const Json texture =
                add_texture(*textures_.surface, "occlusionRoughnessMetallic", false);
            if (material_.occlusion) {
                material["occlusionTexture"] = texture;
            }
            if (material_.roughness || material_.metallic) {
                material["pbrMetallicRoughness"]["metallicRoughnessTexture"] = texture;
            }
        }
        if (textures_.emission) {
            material["emissiveTexture"] = add_texture(*textures_.emission, "emissive", true);
            material["emissiveFactor"] = {1.0, 1.0, 1.0};
        }
    }

    const SceneMaterial& material_;
    const PreviewTextures& textures_;
    GlbBuilder builder_;
};

}  // namespace

Bytes glb(const SceneMaterial& material, const PreviewTextures& textures) {
    return GlbWriter(material, textures).write();
}

}  // namespace foam::texgen
