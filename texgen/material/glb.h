// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/files/file_io.h"
#include "texgen/material/preview_textures.h"
#include "texgen/material/scene_material.h"

namespace foam::texgen {

/// Returns a scene of glTF 2.0 in one binary file (.glb): a rectangle in the plane z = 0, which
/// faces +z. Its textures are PNGs of the first frame only, because glTF has no animated textures.
/// If the images tile, the rectangle shows 2 x 2 tiles. If the colors are those of the map `lit`,
/// they contain light already. The extension KHR_materials_unlit then makes viewers show them as
/// they are, without lighting them again.
Bytes glb(const SceneMaterial& material, const PreviewTextures& textures);

}  // namespace foam::texgen
