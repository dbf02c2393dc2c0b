// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

namespace foam::texgen {

/// The files of the variations of a preset in a folder.
class VariationFiles {
  public:
    /// `preset` is the name of the preset, `count` the number of variations.
    VariationFiles(std::filesystem::path folder, const std::string& preset, std::size_t count);

    /// Returns the path of the sheet, {preset}_variations.png.
    std::filesystem::path sheet() const;

    /// Returns the path of the preset file of a variation, such as {preset}_07.toml. Numbers count
    /// from 1.
    std::filesystem::path preset(std::size_t number) const;

    /// Returns the preset files of variations that earlier runs wrote into the folder. Throws
    /// OutputError if a file or folder with such a name was not written by write_variation.
    std::vector<std::filesystem::path> earlier() const;

  private:
    bool is_variation_name(const std::string& name) const;

    std::filesystem::path folder_;
    std::string stem_;
    std::size_t digits_;
};

/// Writes the preset file of a variation. Its first line marks the file, so that the next run may
/// replace or remove it. Throws OutputError.
void write_variation(const std::filesystem::path& path, const std::string& toml);

}  // namespace foam::texgen
