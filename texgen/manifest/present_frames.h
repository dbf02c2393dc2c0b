#pragma once

#include "texgen/bake/bake.h"
#include "texgen/manifest/manifest.h"
#include "texgen/preset/preset.h"

#include <filesystem>
#include <set>
#include <vector>

namespace foam::texgen {

/// Of the frames of a preset those whose files are all in the folder, were baked with the same
/// parameters, by the same version, and still have the pixels that were.
std::set<int> present_frames(const Preset& preset,
                             const std::vector<int>& frames,
                             const std::filesystem::path& folder,
                             const Manifest& manifest);

}  // namespace foam::texgen
