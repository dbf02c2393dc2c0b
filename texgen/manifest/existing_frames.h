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

/// Returns the subset of `frames` whose files a resumed bake can keep. `folder` is the folder of
/// the manifest. If no set of the manifest has the hash that a bake of the preset would record
/// (BakedSet::parameters), the subset is empty. Otherwise it contains the frames that meet these
/// conditions:
/// - The set lists a file of the frame for every image of the preset (drawn_images); several images
///   may share one EXR. If the preset writes vector files, the set lists a file for every part of
///   the frame (vector_parts).
/// - Each of these files still has the hash that the manifest records (ManifestFile::pixels).
/// - None of these files contains a map that the preset does not have.
/// - The set has, for the frame, all measurements that the key output.measurements lists.
std::set<int> existing_frames_of(const Preset& preset,
                                 const std::vector<int>& frames,
                                 const std::filesystem::path& folder,
                                 const Manifest& manifest);

}  // namespace foam::texgen
