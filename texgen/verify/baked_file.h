// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/image/picture.h"
#include "texgen/manifest/manifest.h"

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace foam::texgen {

/// The picture in a file; null if the file is unreadable or if the hash of its pixels differs from
/// the hash in the manifest.
using DecodedFile = std::shared_ptr<const Picture>;

/// Returns the picture in a file if its pixels have the hash in the manifest. Otherwise adds a line
/// to `problems` and returns null. `folder` is the folder of the manifest.
DecodedFile read_baked(const ManifestFile& file,
                       const std::filesystem::path& folder,
                       std::vector<std::string>& problems);

/// Returns true if the content of a vector file has the hash in the manifest. Otherwise adds a line
/// to `problems` and returns false. `folder` is the folder of the manifest.
bool is_unchanged_vector_file(const ManifestFile& file,
                              const std::filesystem::path& folder,
                              std::vector<std::string>& problems);

}  // namespace foam::texgen
