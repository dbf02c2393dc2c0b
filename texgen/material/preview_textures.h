// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/image/image.h"
#include "texgen/material/scene_material.h"

#include <cstdint>
#include <optional>

namespace foam::texgen {

/// The textures of a material of glTF, made of the images of the first frame. All have 8 bits per
/// sample. If the colors are those of the map lit, there are no other textures.
struct PreviewTextures {
    // Colors as sRGB: of the material without light or, if there is none, of the map lit. With a
    // fourth channel, the opacity, if the material has one.
    std::optional<Image<std::uint8_t>> color;
    std::optional<Image<std::uint8_t>> emission;  // as sRGB
    std::optional<Image<std::uint8_t>> normal;    // y is up
    // Occlusion, roughness and metalness. A number that the material lacks is 1, and the metalness
    // is 0.
    std::optional<Image<std::uint8_t>> surface;
};

/// Reads the images of the first frame, of any format, and converts them. Throws InputError if an
/// image cannot be read.
PreviewTextures preview_textures(const SceneMaterial& material);

}  // namespace foam::texgen
