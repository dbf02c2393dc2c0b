// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/material/scene_material.h"

#include <string>

namespace foam::texgen {

/// Returns a scene of OpenUSD as text: a rectangle in the plane z = 0, which faces +z, and its
/// material, a UsdPreviewSurface. The frames are time samples: the time code of a frame is its
/// number. Paths of images are relative to the folder of the manifest, where the scene belongs.
/// Precondition: the images are in PNG or EXR files, one image per file.
std::string usda_text(const SceneMaterial& material);

}  // namespace foam::texgen
