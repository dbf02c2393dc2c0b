#pragma once

#include "texgen/bake/bake.h"
#include "texgen/manifest/manifest.h"
#include "texgen/preset/preset.h"

#include <filesystem>
#include <vector>

namespace foam::texgen {

/// What a manifest says of a bake of these frames before any of them is there.
BakedSet describe(const Preset& preset, const std::vector<int>& frames);

/// Adds a frame that has been written; the paths of its files are told relative to the folder.
void add_frame(BakedSet& set, const BakedFrame& baked, const std::filesystem::path& folder);

/// As it stands in a manifest.
std::string relative_path(const std::filesystem::path& path, const std::filesystem::path& folder);

}  // namespace foam::texgen
