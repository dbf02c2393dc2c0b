// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/json/json_writer.h"

#include <filesystem>
#include <stdexcept>
#include <string>
#include <vector>

namespace foam::texgen {

/// Reports that a path, such as one that the studio's page has sent, may not be used
/// (StudioFolder::below). The message is one line.
class PathRejected : public std::runtime_error {
    using runtime_error::runtime_error;
};

/// The folder below which a studio reads and writes files.
class StudioFolder {
  public:
    /// Creates the folder if it does not exist. Throws OutputError if it cannot be created, or if
    /// the path names something that is not a folder.
    explicit StudioFolder(const std::filesystem::path& folder);

    /// Returns the absolute path of the folder, without links.
    const std::filesystem::path& path() const { return path_; }

    /// Returns the absolute path, without links, of a file or folder below this folder. `relative`
    /// is its path relative to this folder. The file or folder need not exist. Throws PathRejected
    /// if `relative` is absolute, contains ".." or control characters, leaves this folder through a
    /// link, or cannot be resolved.
    std::filesystem::path below(const std::string& relative) const;

    /// Returns the names of the files in the folder that end in .toml and are plain names
    /// (is_plain_name), sorted.
    std::vector<std::string> preset_files() const;

    /// Returns the paths, relative to the folder, of the manifests of bakes in the folder and in
    /// folders up to three levels below it, sorted. At most 200 are returned.
    std::vector<std::filesystem::path> bakes() const;

  private:
    std::filesystem::path path_;
};

}  // namespace foam::texgen
