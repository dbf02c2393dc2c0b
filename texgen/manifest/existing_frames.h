// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/bake/bake.h"
#include "texgen/manifest/manifest.h"
#include "texgen/preset/preset.h"

#include <filesystem>
#include <set>
#include <string>
#include <vector>

namespace foam::texgen {

/// Returns the hash that the manifest records for a vector file or a scene file: the text_hash of
/// its content. Throws InputError, whose message names the file, if the file cannot be read.
std::string file_hash(const std::filesystem::path& path);

/// Returns the subset of `frames` whose files a resumed bake can keep. For every map of the preset,
/// the manifest must list a file of the frame in the set that has the BakedSet::parameters of the
/// preset. The file must still have the pixels that the manifest records, and must contain no map
/// that the preset does not have. For the frame, the set must also have the measurements that
/// output.measurements lists. `folder` is the folder of the manifest.
std::set<int> existing_frames_of(const Preset& preset,
                                 const std::vector<int>& frames,
                                 const std::filesystem::path& folder,
                                 const Manifest& manifest);

}  // namespace foam::texgen
