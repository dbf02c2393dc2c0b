// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/bake/bake.h"
#include "texgen/manifest/manifest.h"
#include "texgen/preset/preset.h"

#include <filesystem>
#include <vector>

namespace foam::texgen {

/// Returns a set that describes a bake of the given frames of a preset. The set has no files yet.
BakedSet describe(const Preset& preset, const std::vector<int>& frames);

/// Adds a frame to a set, after the files of the frame have been written. `folder` is the folder of
/// the manifest; the paths of the files are stored relative to it. Precondition: the set has all
/// maps of the files.
void add_frame(BakedSet& set, const BakedFrame& baked, const std::filesystem::path& folder);

/// Returns a path relative to the folder of the manifest, with '/' as separator, as manifests store
/// it.
std::string relative_path(const std::filesystem::path& path, const std::filesystem::path& folder);

}  // namespace foam::texgen
