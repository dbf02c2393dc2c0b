// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/bake/bake.h"
#include "texgen/manifest/manifest.h"
#include "texgen/preset/preset.h"

#include <filesystem>
#include <vector>

namespace foam::texgen {

/// Returns a set that describes a bake of the given frames of a preset. The frames may be given in
/// any order. The set has no files and no statistics yet.
BakedSet describe(const Preset& preset, const std::vector<int>& frames);

/// Adds the files and the statistics of a baked frame to a set. `folder` is the folder of the
/// manifest; the paths of the files are stored relative to it. Precondition: the set has all maps
/// of the files.
void add_frame(BakedSet& set, const BakedFrame& baked, const std::filesystem::path& folder);

/// Converts a path to the form in which manifests store it: relative to `folder`, the folder of the
/// manifest, with '/' as separator.
std::string relative_path(const std::filesystem::path& path, const std::filesystem::path& folder);

}  // namespace foam::texgen
