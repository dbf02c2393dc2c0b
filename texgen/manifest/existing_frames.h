// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/bake/bake.h"
#include "texgen/manifest/manifest.h"
#include "texgen/preset/preset.h"

#include <filesystem>
#include <set>
#include <vector>

namespace foam::texgen {

/// Returns those of `frames` whose files all exist in the folder, were baked with the same
/// parameters and version, and still have the pixels that the manifest records.
std::set<int> existing_frames_of(const Preset& preset,
                                 const std::vector<int>& frames,
                                 const std::filesystem::path& folder,
                                 const Manifest& manifest);

}  // namespace foam::texgen
