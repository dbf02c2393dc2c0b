// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/preset/preset.h"

#include <cstddef>
#include <optional>

namespace foam::texgen {

/// A channel of an image of a preset. The channel holds one property of the material, such as the
/// roughness.
struct SceneSource {
    std::size_t image = 0;    // index in drawn_images(preset)
    std::size_t channel = 0;  // index of the channel in this image
    bool inverted = false;    // true if the channel holds 1 minus the property

    friend bool operator==(const SceneSource&, const SceneSource&) = default;
};

/// The images of a preset (drawn_images) that make its material in a scene file. Images are given
/// by their indices.
struct SceneSources {
    // Colors that do not contain light: the map base_color_map(preset), or a packing of its
    // channels R, G and B.
    std::optional<std::size_t> base_color;
    // If there is no base color: the map `lit`, or a packing of its channels R, G and B. Its colors
    // contain light already, so the material adds no light to them.
    std::optional<std::size_t> lit;
    // If `lit` is not set: the map `emission`, or a packing of its channels R, G and B.
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
