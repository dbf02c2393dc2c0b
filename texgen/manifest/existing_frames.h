// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/bake/bake.h"
#include "texgen/manifest/manifest.h"
#include "texgen/preset/preset.h"

#include <filesystem>
#include <set>
#include <vector>

namespace foam::texgen {

/// Returns the subset of `frames` whose files can be kept by a resumed bake. For every map of the
/// preset, the file of such a frame exists, is in a set with the same BakedSet::parameters, still
/// has the pixels that the manifest records, and contains no map that the preset does not have.
/// `folder` is the folder of the manifest.
std::set<int> existing_frames_of(const Preset& preset,
                                 const std::vector<int>& frames,
                                 const std::filesystem::path& folder,
                                 const Manifest& manifest);

}  // namespace foam::texgen
