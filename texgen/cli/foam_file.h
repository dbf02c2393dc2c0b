// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/foam/foam.h"

#include <filesystem>
#include <string>
#include <vector>

namespace foam::texgen {

/// A foam from a file.
struct LoadedFoam {
    Foam foam;
    std::vector<std::string> notes;  // parts of the file that were ignored, one line each
};

/// Throws std::invalid_argument, with a message that lists the allowed extensions, unless the name
/// ends in one of them: .fe or .dmp for files of Surface Evolver, .json for a state of foamtex.
void check_foam_name(const std::filesystem::path& path);

/// Reads a foam from a file. Throws InputError if the file cannot be read, FormatError if it is
/// malformed, and the exceptions of check_foam_name.
LoadedFoam load_foam(const std::filesystem::path& path);

/// Writes a foam to a file, atomically (write_file). Throws OutputError if the file cannot be
/// written, and the exceptions of check_foam_name.
void save_foam(const std::filesystem::path& path, const Foam& foam);

}  // namespace foam::texgen
