// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/preset/preset.h"

#include <filesystem>
#include <vector>

namespace foam::texgen {

/// Checks that the scene files of output.scene can be written, before a bake begins. Throws
/// std::invalid_argument in these cases:
/// - No image of the preset is part of a material.
/// - The files of the bake are vector files.
/// - A scene format cannot refer to the images of the bake.
///
/// OpenUSD and MaterialX need PNG files, or EXR files with one map each. OpenUSD also needs
/// straight colors (not multiplied by the opacity) with the primaries of sRGB. A scene of glTF
/// contains its images, so all image formats are possible.
void check_scenes(const Preset& preset);

/// Writes the scene files of output.scene for a preset, whose bake has just ended, into the folder
/// of the manifest: {preset}.usda, {preset}.mtlx and {preset}.glb. Existing files are replaced.
/// Lists the files in the manifest. Returns their paths, in the order of output.scene. Throws
/// InputError if the manifest or an image cannot be read, or if no frame has all images of the
/// material. Throws OutputError if a file cannot be written. Precondition: check_scenes does not
/// throw.
std::vector<std::filesystem::path> write_scenes(const Preset& preset);

}  // namespace foam::texgen
