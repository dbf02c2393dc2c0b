// SPDX-License-Identifier: Apache-2.0

#include "texgen/mesh/glb_builder.h"

#include <bit>
#include <utility>

namespace foam::texgen {

namespace {

// Numbers of the glTF 2.0 specification.
constexpr int kFloat = 5126;
constexpr int kUnsignedShort = 5123;
constexpr int kUnsignedInt = 5125;
constexpr int kArrayBuffer = 34962;
constexpr int kElementArrayBuffer = 34963;
constexpr std::uint32_t kMagic = 0x46546C67;        // "glTF"
constexpr std::uint32_t kJsonChunk = 0x4E4F534A;    // "JSON"
constexpr std::uint32_t kBinaryChunk = 0x004E4942;  // "BIN"

static_assert(std::endian::native == std::endian::little, "files of glTF are little-endian");

void append_number(Bytes& bytes, std::uint32_t number) {
    append(bytes, std::as_bytes(std::span(&number, 1)));
}

void pad(Bytes& bytes, char fill) {
    while (bytes.size() % 4 != 0) {
        bytes.push_back(static_cast<std::byte>(fill));
    }
}

}  // namespace

GlbBuilder::GlbBuilder(std::string_view node_name) {
    json["asset"] = {{"version", "2.0"}, {"generator", "foamtex " FOAMTEX_VERSION}};
    json["scene"] = 0;
    json["scenes"] = Json::array({{{"nodes", {0}}}});
    json["nodes"] = Json::array({{{"name", node_name}, {"mesh", 0}}});
}

std::size_t GlbBuilder::add_view(std::span<const std::byte> content, int target) {
    pad(binary_, 0);
    Json view{{"buffer", 0}, {"byteOffset", binary_.size()}, {"byteLength", content.size()}};
    if (target != 0) {
        view["target"] = target;
    }
    append(binary_, content);
    json["bufferViews"].push_back(std::move(view));
    return json["bufferViews"].size() - 1;
}

std::size_t GlbBuilder::add_bytes(std::span<const std::byte> content) {
    return add_view(content, 0);
}

std::size_t GlbBuilder::add_accessor(Json accessor) {
    json["accessors"].push_back(std::move(accessor));
    return json["accessors"].size() - 1;
}

std::size_t GlbBuilder::add_vectors(std::span<const float> numbers,
                                    int components,
                                    const Json& limits) {
    Json accessor{{"bufferView", add_view(std::as_bytes(numbers), kArrayBuffer)},
                  {"componentType", kFloat},
                  {"count", numbers.size() / static_cast<std::size_t>(components)},
                  {"type", "VEC" + std::to_string(components)}};
    accessor.update(limits);
    return add_accessor(std::move(accessor));
}

std::size_t GlbBuilder::add_corners(std::span<const std::uint16_t> corners) {
    return add_accessor({{"bufferView", add_view(std::as_bytes(corners), kElementArrayBuffer)},
                         {"componentType", kUnsignedShort},
                         {"count", corners.size()},
                         {"type", "SCALAR"}});
}

std::size_t GlbBuilder::add_corners(std::span<const std::uint32_t> corners) {
    return add_accessor({{"bufferView", add_view(std::as_bytes(corners), kElementArrayBuffer)},
                         {"componentType", kUnsignedInt},
                         {"count", corners.size()},
                         {"type", "SCALAR"}});
}

void GlbBuilder::set_mesh(std::string_view name, Json primitive) {
    json["meshes"] =
        Json::array({{{"name", name}, {"primitives", Json::array({std::move(primitive)})}}});
}

Bytes GlbBuilder::file() {
    pad(binary_, 0);
    json["buffers"] = Json::array({{{"byteLength", binary_.size()}}});
    const std::string text = json_text(json);
    Bytes padded;
    append(padded, std::as_bytes(std::span(text)));
    pad(padded, ' ');
    const std::size_t total = 28 + padded.size() + binary_.size();
    Bytes file;
    file.reserve(total);
    append_number(file, kMagic);
    append_number(file, 2);  // version
    append_number(file, static_cast<std::uint32_t>(total));
    append_number(file, static_cast<std::uint32_t>(padded.size()));
    append_number(file, kJsonChunk);
    append(file, padded);
    append_number(file, static_cast<std::uint32_t>(binary_.size()));
    append_number(file, kBinaryChunk);
    append(file, binary_);
    return file;
}

}  // namespace foam::texgen
