// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/manifest/manifest.h"

#include <filesystem>
#include <string>
#include <vector>

namespace foam::texgen {

/// Returns a line for each scene file of a set that is missing, or whose content differs from the
/// content that was written. `folder` is the folder of the manifest.
std::vector<std::string> scene_problems(const BakedSet& set, const std::filesystem::path& folder);

}  // namespace foam::texgen
