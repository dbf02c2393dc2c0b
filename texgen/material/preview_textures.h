// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/image/image.h"
#include "texgen/material/scene_material.h"

#include <cstdint>
#include <optional>

namespace foam::texgen {

/// The textures of a material of glTF, made of the images of the first frame. All have 8 bits per
/// sample. If the colors are those of the map `lit`, there are no other textures.
struct PreviewTextures {
    // Colors as sRGB: the base color or, if there is none, the map `lit`. A fourth channel holds
    // the opacity if the material has one. A material that has an opacity but no colors is white.
    std::optional<Image<std::uint8_t>> color;
    std::optional<Image<std::uint8_t>> emission;  // as sRGB
    std::optional<Image<std::uint8_t>> normal;    // y is up
    // Occlusion, roughness and metalness. An occlusion or roughness that the material lacks is 1; a
    // metalness that it lacks is 0.
    std::optional<Image<std::uint8_t>> surface;
};

/// Reads the images of the first frame, of any format, and converts them. Throws InputError if an
/// image cannot be read or lacks a channel.
PreviewTextures preview_textures(const SceneMaterial& material);

}  // namespace foam::texgen
