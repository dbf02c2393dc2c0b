// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <filesystem>

namespace foam {

/// Removes the temporary files that killed programs have left in a folder. These are the files with
/// the temporary names of StagedFile whose last change is more than a day ago. An empty path means
/// the working directory. Ignores errors: does nothing if the folder does not exist.
void remove_abandoned_files(const std::filesystem::path& folder);

}  // namespace foam
