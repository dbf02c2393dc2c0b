// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/preset/assignment.h"

#include <filesystem>
#include <span>
#include <string>
#include <vector>

namespace foam::texgen {

/// Returns the files on which a preset depends, each once. These are its file, the files of the
/// presets that it extends, and the pictures and drawings that the keys of all these presets name
/// (locate_files). `more` are further assignments, such as those of --set; their paths are relative
/// to the working folder. The files need not exist. Shipped presets have no file. Does not throw if
/// a file is unreadable or is no preset; the result then lacks the files that this file names.
std::vector<std::filesystem::path> preset_files(const std::string& name_or_path,
                                                std::span<const Assignment> more = {});

}  // namespace foam::texgen
