// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/preset/preset.h"

#include <cstddef>
#include <optional>

namespace foam::texgen {

/// A channel of one of the images of a preset that holds a number of the material.
struct SceneSource {
    std::size_t image = 0;    // index in drawn_images(preset)
    std::size_t channel = 0;  // index of the channel in this image
    bool inverted = false;    // true if the channel holds 1 minus the number

    friend bool operator==(const SceneSource&, const SceneSource&) = default;
};

/// The images of a preset (drawn_images) that make its material in a scene file. Images are given
/// by their indices.
struct SceneSources {
    // The colors without light: the map base_color_map, or a packing of its channels R, G and B.
    std::optional<std::size_t> base_color;
    // The map lit, or a packing of its channels R, G and B, if there is no base color. Its colors
    // contain light already, so the material shows them as they are.
    std::optional<std::size_t> lit;
    // The map emission, or a packing of its channels R, G and B, if `lit` is not set.
    std::optional<std::size_t> emission;
    // Normals, as a map and not packed. A map whose y is up is preferred.
    std::optional<std::size_t> normal;
    bool is_normal_down = false;  // true if positive y is down in these normals
    // The maps of these names, or channels of packings that contain them.
    std::optional<SceneSource> roughness;
    std::optional<SceneSource> metallic;
    std::optional<SceneSource> occlusion;
    std::optional<SceneSource> opacity;
    std::optional<SceneSource> height;

    /// Returns true if no image is part of the material.
    bool is_empty() const;
};

/// Finds the images of a preset that make its material. A map is preferred to a packing that
/// contains it.
SceneSources scene_sources(const Preset& preset);

}  // namespace foam::texgen
