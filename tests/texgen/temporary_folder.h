// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/image/scratch_folder.h"

#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

namespace foam::texgen {

/// An empty folder of its own for a test, gone afterwards.
class TemporaryFolder : public ScratchFolder {
  public:
    /// The names of what lies in the folder, at any depth, folders not counted.
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

}  // namespace foam::texgen
