// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/bake/file_pattern.h"

#include <map>

namespace foam::texgen {

/// Returns the existing files of a pattern by frame number. Returns no files if the folder of the
/// pattern does not exist or cannot be read. If the pattern has the frame number in the name of a
/// folder, throws std::filesystem::filesystem_error if a subfolder cannot be read. Precondition:
/// the pattern contains a placeholder of the frame number, but not {map}.
std::map<int, std::filesystem::path> existing_sequence(const FilePattern& pattern);

}  // namespace foam::texgen
