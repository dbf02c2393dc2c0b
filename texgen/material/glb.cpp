// SPDX-License-Identifier: Apache-2.0

#include "texgen/material/glb.h"

#include "texgen/image/png.h"
#include "texgen/json/json_writer.h"

#include <array>
#include <bit>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace foam::texgen {

namespace {

// Numbers of the glTF 2.0 specification.
constexpr int kFloat = 5126;
constexpr int kUnsignedShort = 5123;
constexpr int kArrayBuffer = 34962;
constexpr int kElementArrayBuffer = 34963;
constexpr int kLinear = 9729;
constexpr int kLinearMipmapLinear = 9987;
constexpr int kRepeat = 10497;
constexpr int kClampToEdge = 33071;
constexpr std::uint32_t kMagic = 0x46546C67;        // "glTF"
constexpr std::uint32_t kJsonChunk = 0x4E4F534A;    // "JSON"
constexpr std::uint32_t kBinaryChunk = 0x004E4942;  // "BIN"

constexpr double kGray = 0.5;       // base color of a material without colors
constexpr double kRoughness = 0.5;  // of a material without a map of the roughness

static_assert(std::endian::native == std::endian::little, "files of glTF are little-endian");

void append_number(Bytes& bytes, std::uint32_t number) {
    append(bytes, std::as_bytes(std::span(&number, 1)));
}

void pad(Bytes& bytes, char with) {
    while (bytes.size() % 4 != 0) {
        bytes.push_back(static_cast<std::byte>(with));
    }
}

// Returns the components of a vector that is the same at all corners of the plane.
std::vector<float> at_all_corners(const std::vector<float>& vector) {
    std::vector<float> all;
    for (int corner = 0; corner < 4; ++corner) {
        all.insert(all.end(), vector.begin(), vector.end());
    }
    return all;
}

// Builds the JSON and the binary part of a file.
class GlbWriter {
  public:
    GlbWriter(const SceneMaterial& material, const PreviewTextures& textures)
        : material_(material), textures_(textures) {}

    Bytes write() {
        json_["asset"] = {{"version", "2.0"}, {"generator", "foamtex " FOAMTEX_VERSION}};
        json_["scene"] = 0;
        json_["scenes"] = Json::array({{{"nodes", {0}}}});
        json_["nodes"] = Json::array({{{"name", material_.preset}, {"mesh", 0}}});
        write_material();
        write_mesh();
        pad(binary_, 0);
        json_["buffers"] = Json::array({{{"byteLength", binary_.size()}}});
        return join();
    }

  private:
    std::size_t add_view(std::span<const std::byte> content, int target) {
        pad(binary_, 0);
        Json view{{"buffer", 0}, {"byteOffset", binary_.size()}, {"byteLength", content.size()}};
        if (target != 0) {
            view["target"] = target;
        }
        append(binary_, content);
        json_["bufferViews"].push_back(std::move(view));
        return json_["bufferViews"].size() - 1;
    }

    std::size_t add_vectors(std::span<const float> numbers, int components, const Json& limits) {
        Json accessor{{"bufferView", add_view(std::as_bytes(numbers), kArrayBuffer)},
                      {"componentType", kFloat},
                      {"count", numbers.size() / static_cast<std::size_t>(components)},
                      {"type", "VEC" + std::to_string(components)}};
        accessor.update(limits);
        json_["accessors"].push_back(std::move(accessor));
        return json_["accessors"].size() - 1;
    }

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
            add_vectors(positions, 3, {{"min", {-x, -y, 0.0F}}, {"max", {x, y, 0.0F}}});
        attributes["NORMAL"] = add_vectors(at_all_corners({0, 0, 1}), 3, Json::object());
        if (textures_.normal) {
            attributes["TANGENT"] = add_vectors(at_all_corners({1, 0, 0, 1}), 4, Json::object());
        }
        if (json_.contains("textures")) {
            attributes["TEXCOORD_0"] = add_vectors(coordinates, 2, Json::object());
        }
        const std::array<std::uint16_t, 6> corners{0, 1, 2, 0, 2, 3};
        json_["accessors"].push_back(
            {{"bufferView", add_view(std::as_bytes(std::span(corners)), kElementArrayBuffer)},
             {"componentType", kUnsignedShort},
             {"count", corners.size()},
             {"type", "SCALAR"}});
        json_["meshes"] = Json::array({{{"name", material_.preset},
                                        {"primitives",
                                         Json::array({{{"attributes", attributes},
                                                       {"indices", json_["accessors"].size() - 1},
                                                       {"material", 0}}})}}});
    }

    Json add_texture(const Image<std::uint8_t>& pixels, const char* name, bool is_color) {
        if (!json_.contains("samplers")) {
            const int wrap = material_.tiles ? kRepeat : kClampToEdge;
            json_["samplers"] = Json::array({{{"magFilter", kLinear},
                                              {"minFilter", kLinearMipmapLinear},
                                              {"wrapS", wrap},
                                              {"wrapT", wrap}}});
        }
        const Bytes png = encode_png(pixels.view(), {.color = is_color}, {.filter = PngFilter::Up});
        json_["images"].push_back(
            {{"name", name}, {"mimeType", "image/png"}, {"bufferView", add_view(png, 0)}});
        json_["textures"].push_back({{"sampler", 0}, {"source", json_["images"].size() - 1}});
        return {{"index", json_["textures"].size() - 1}};
    }

    Json metallic_roughness() {
        Json model;
        if (textures_.color) {
            model["baseColorTexture"] = add_texture(*textures_.color, "baseColor", true);
        } else {
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
            json_["extensionsUsed"] = {"KHR_materials_unlit"};
        } else {
            write_details(material);
        }
        json_["materials"] = Json::array({material});
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

    // Joins the header and both chunks.
    Bytes join() const {
        const std::string text = json_text(json_);
        Bytes json;
        append(json, std::as_bytes(std::span(text)));
        pad(json, ' ');
        Bytes file;
        append_number(file, kMagic);
        append_number(file, 2);  // version
        append_number(file, static_cast<std::uint32_t>(28 + json.size() + binary_.size()));
        append_number(file, static_cast<std::uint32_t>(json.size()));
        append_number(file, kJsonChunk);
        append(file, json);
        append_number(file, static_cast<std::uint32_t>(binary_.size()));
        append_number(file, kBinaryChunk);
        append(file, binary_);
        return file;
    }

    const SceneMaterial& material_;
    const PreviewTextures& textures_;
    Json json_;
    Bytes binary_;
};

}  // namespace

Bytes glb(const SceneMaterial& material, const PreviewTextures& textures) {
    return GlbWriter(material, textures).write();
}

}  // namespace foam::texgen
