// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/preset/assignment.h"

#include <filesystem>
#include <span>
#include <string>
#include <vector>

namespace foam::texgen {

/// Returns the files on which a preset depends, each once: its file, the files of the presets that
/// it extends, and the pictures that they name. Any value of a key that ends in .png, .exr or .svg
/// is regarded as the path of a picture, relative to the folder of the preset that names it and to
/// the working folder; keys of the table `output`, which name files that are written, are left out.
/// `more` are further assignments, such as those of --set. The files need not exist. Shipped
/// presets have no file. Does not throw if a file is unreadable or is no preset; the files that it
/// names are then missing.
std::vector<std::filesystem::path> preset_files(const std::string& name_or_path,
                                                std::span<const Assignment> more = {});

}  // namespace foam::texgen
