// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/files/scratch_folder.h"

#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

namespace foam {

/// A new empty folder for a test. The destructor removes the folder with its content.
class TemporaryFolder : public ScratchFolder {
  public:
    /// Returns the paths of all files in the folder and its subfolders, relative to the folder and
    /// sorted.
    std::vector<std::string> files() const {
        std::vector<std::string> names;
        for (const auto& entry : std::filesystem::recursive_directory_iterator(path())) {
            if (!entry.is_directory()) {
                names.push_back(std::filesystem::relative(entry.path(), path()).string());
            }
        }
        std::sort(names.begin(), names.end());
        return names;
    }
};

}  // namespace foam
