// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <filesystem>

namespace foam {

/// A new empty folder in the system's folder for temporary files. The destructor removes the folder
/// with its content.
class ScratchFolder {
  public:
    /// Throws OutputError if the folder cannot be created.
    ScratchFolder();
    ~ScratchFolder();
    ScratchFolder(const ScratchFolder&) = delete;
    ScratchFolder& operator=(const ScratchFolder&) = delete;

    const std::filesystem::path& path() const { return path_; }

  private:
    std::filesystem::path path_;
};

}  // namespace foam
