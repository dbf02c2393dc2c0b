// SPDX-License-Identifier: Apache-2.0

#include "texgen/material/scene_files.h"

#include "core/files/content_text.h"
#include "core/files/file_io.h"
#include "texgen/bake/file_pattern.h"
#include "texgen/image/format.h"
#include "texgen/image/pixel_hash.h"
#include "texgen/image/texture_file.h"
#include "texgen/manifest/bake_recorder.h"
#include "texgen/manifest/manifest_file.h"
#include "texgen/material/glb.h"
#include "texgen/material/materialx.h"
#include "texgen/material/preview_textures.h"
#include "texgen/material/scene_material.h"
#include "texgen/material/scene_sources.h"
#include "texgen/material/usda.h"

#include <fmt/format.h>

#include <span>
#include <stdexcept>
#include <string_view>

namespace foam::texgen {

namespace {

constexpr std::string_view kGltf = "gltf";
constexpr std::string_view kUsda = "usda";

// Returns the suffix of the scene files of a format. A glTF scene is one binary file (".glb"),
// which contains its images.
std::string_view suffix_of(std::string_view format) {
    return format == kGltf ? "glb" : format;
}

Bytes content_of(std::string_view format, const SceneMaterial& material) {
    if (format == kGltf) {
        return glb(material, preview_textures(material));
    }
    const std::string text = format == kUsda ? usda_text(material) : materialx_text(material);
    Bytes content;
    append(content, std::as_bytes(std::span(text)));
    return content;
}

// Returns true if scene files can refer to the images of a bake. Each map must have a file of its
// own, and the files must not be textures (DDS or KTX2). Precondition: pattern.is_vector() is
// false.
bool has_single_images(const FilePattern& pattern) {
    return find_texture_format(pattern.format().suffix) == nullptr &&
           !pattern.stores_all_maps_in_one_file();
}

// Throws std::invalid_argument if a UsdPreviewSurface cannot show the colors of a bake.
// Precondition: has_single_images(pattern).
void check_usd_colors(const Preset& preset, const FilePattern& pattern) {
    if (preset.output.primaries != Primaries::Srgb) {
        throw std::invalid_argument(
            "output.scene = \"usda\" cannot refer to colors with output.primaries = \"acescg\", "
            "because the textures of a UsdPreviewSurface have the primaries of sRGB; a scene of "
            "the format mtlx or gltf is possible");
    }
    const SceneSources sources = scene_sources(preset);
    const bool has_colors = sources.base_color || sources.lit || sources.emission;
    const bool is_premultiplied = pattern.format().samples == FormatSamples::Numbers;
    if (has_colors && is_premultiplied && preset.shape.kind == FoamKind::Patch) {
        throw std::invalid_argument(fmt::format(
            "output.scene = \"usda\" cannot refer to the colors of a patch in {} files, because "
            "these colors are multiplied by the opacity, and a UsdPreviewSurface would multiply "
            "them again; PNG files, or a scene of the format mtlx or gltf, are possible",
            pattern.format().name));
    }
}

}  // namespace

void check_scenes(const Preset& preset) {
    if (preset.output.scene.empty()) {
        return;
    }
    if (scene_sources(preset).is_empty()) {
        throw std::invalid_argument(fmt::format(
            "output.scene needs a map of a material, such as albedo, lit, normal, height, "
            "roughness, metallic, occlusion or emission, but image.maps has only {}; set "
            "output.scene to [] for no scene",
            fmt::join(preset.image.maps, ", ")));
    }
    const FilePattern pattern(preset);
    if (pattern.is_vector()) {
        throw std::invalid_argument(fmt::format(
            "output.scene needs images, but output.pattern is '{}'; set output.scene to [] for no "
            "scene",
            preset.output.pattern));
    }
    const bool can_refer = has_single_images(pattern);
    for (const std::string& format : preset.output.scene) {
        if (format != kGltf && !can_refer) {
            throw std::invalid_argument(fmt::format(
                "output.scene = \"{}\" needs PNG files, or EXR files with {{map}} in their names, "
                "but output.pattern is '{}'; a scene of the format gltf is possible",
                format,
                preset.output.pattern));
        }
        if (format == kUsda) {
            check_usd_colors(preset, pattern);
        }
    }
}

std::vector<std::filesystem::path> write_scenes(const Preset& preset) {
    const std::filesystem::path folder = manifest_folder(preset);
    const BakedSet set = read_manifest(folder).sets.back();
    const SceneMaterial material = scene_material(preset, set, folder);
    std::vector<std::filesystem::path> paths;
    std::vector<StagedFile> staged;
    std::vector<ManifestScene> scenes;
    for (const std::string& format : preset.output.scene) {
        const std::string name = fmt::format("{}.{}", preset.name, suffix_of(format));
        const Bytes content = content_of(format, material);
        staged.emplace_back(folder / name, content);
        scenes.push_back({name, format, content.size(), text_hash(as_text(content))});
        paths.push_back(folder / name);
    }
    for (StagedFile& file : staged) {
        file.publish();
    }
    update_manifest(folder,
                    [&](Manifest& manifest) { add_scenes(manifest, set.parameters, scenes); });
    return paths;
}

}  // namespace foam::texgen
