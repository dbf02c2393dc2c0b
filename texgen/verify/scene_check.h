// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/manifest/manifest.h"

#include <filesystem>
#include <string>
#include <vector>

namespace foam::texgen {

/// Checks the scene files of a set. Returns a line for each file that is missing, that cannot be
/// read, or whose content differs from the content that was written. `folder` is the folder of the
/// manifest.
std::vector<std::string> scene_problems(const BakedSet& set, const std::filesystem::path& folder);

}  // namespace foam::texgen
