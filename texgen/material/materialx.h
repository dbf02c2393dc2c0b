// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/material/scene_material.h"

#include <string>

namespace foam::texgen {

/// Returns a material of MaterialX 1.38 as text: a standard_surface whose images repeat if they
/// tile. The images are those of the first frame, because few programs replace the tokens of
/// MaterialX for frame numbers. Occlusion scales the diffuse reflection, because a standard_surface
/// has no other input for it. Paths of images are relative to the folder of the manifest, where the
/// document belongs. Precondition: the images are in PNG or EXR files, one image per file.
std::string materialx_text(const SceneMaterial& material);

}  // namespace foam::texgen
