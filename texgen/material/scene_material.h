// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/manifest/manifest.h"
#include "texgen/preset/preset.h"
#include "texgen/sheet/map_sequence.h"

#include <array>
#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace foam::texgen {

/// The width of an image in a scene, meters.
inline constexpr double kPlaneWidth = 1.0;

/// An image of a material, and its files of all frames. The number that a sample represents in the
/// material is scale * sample + bias. Codes count as samples from 0 to 1.
struct SceneImage {
    std::string id;                     // a name for nodes, unique in the material (identifier.h)
    MapSequence sequence;               // the files, in the order of SceneMaterial::frames
    std::vector<std::string> paths;     // their paths, relative to the folder of the manifest
    std::vector<std::string> channels;  // the names of the channels in a file, such as "R"
    std::array<double, 4> scale{1.0, 1.0, 1.0, 1.0};
    std::array<double, 4> bias{};

    const MapSamples& samples() const { return *sequence.map.samples; }
    bool is_color() const { return samples().kind == "color"; }
    bool is_premultiplied() const { return samples().alpha == "premultiplied"; }
    bool has_codes() const { return samples().type.starts_with("uint"); }
};

/// A channel of an image of a material.
struct SceneChannel {
    std::size_t image = 0;    // index in SceneMaterial::images
    std::size_t channel = 0;  // 0 for the first channel
};

/// A material as a scene file describes it. Images are given by their indices in `images`. The
/// optional members correspond to the members of SceneSources with the same names.
struct SceneMaterial {
    std::string id;                     // the name of the preset as an identifier
    std::string preset;                 // the name of the preset
    std::string description;            // the description of the preset
    double plane_height = kPlaneWidth;  // the height of an image in a scene, meters
    bool tiles = true;                  // true if the images of all frames tile
    int frames_per_second = 24;
    std::vector<int> frames;  // the frames for which all images exist, in increasing order
    std::vector<SceneImage> images;
    std::optional<std::size_t> base_color;
    std::optional<std::size_t> lit;
    std::optional<std::size_t> emission;
    std::optional<std::size_t> normal;
    bool is_normal_down = false;
    // The alpha channel of `base_color` or `lit`. If there is none and the images do not tile, the
    // channel of SceneSources::opacity.
    std::optional<SceneChannel> opacity;
    std::optional<SceneChannel> roughness;
    std::optional<SceneChannel> metallic;
    std::optional<SceneChannel> occlusion;
    std::optional<SceneChannel> height;
    // The height in meters that the number 1 of the channel `height` represents, for each frame.
    // Empty if there is no channel `height`.
    std::vector<double> displacements;

    /// Returns true if all frames have the same displacement.
    bool has_one_displacement() const;
};

/// Returns the material that the images of a preset make. `set` is the set of a manifest that lists
/// the images of this preset, and `folder` is the folder of the manifest. Throws InputError if no
/// frame has all images of the material. Precondition: scene_sources(preset) is not empty.
SceneMaterial scene_material(const Preset& preset,
                             const BakedSet& set,
                             const std::filesystem::path& folder);

}  // namespace foam::texgen
