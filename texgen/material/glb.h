// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/files/file_io.h"
#include "texgen/material/preview_textures.h"
#include "texgen/material/scene_material.h"

namespace foam::texgen {

/// Returns a scene of glTF 2.0 in one binary file (.glb): a plane in the plane of x and y, which
/// faces z, with the textures of the first frame as PNGs. If the images tile, the plane shows 2 x 2
/// tiles. glTF has no animated textures. Colors of the map lit contain light already, so viewers
/// show them without any light (extension KHR_materials_unlit).
Bytes glb(const SceneMaterial& material, const PreviewTextures& textures);

}  // namespace foam::texgen
