// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/bake/bake.h"
#include "texgen/manifest/manifest.h"
#include "texgen/preset/preset.h"

#include <filesystem>
#include <vector>

namespace foam::texgen {

/// Returns the set of a bake of these frames, without any files yet.
BakedSet describe(const Preset& preset, const std::vector<int>& frames);

/// Adds a frame whose files have been written. Their paths are stored relative to the folder.
void add_frame(BakedSet& set, const BakedFrame& baked, const std::filesystem::path& folder);

/// Returns a path relative to the folder of the manifest, with '/', as manifests store it.
std::string relative_path(const std::filesystem::path& path, const std::filesystem::path& folder);

}  // namespace foam::texgen
