// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/foam/foam.h"

#include <filesystem>
#include <string>
#include <vector>

namespace foam {

/// A foam that was read from a file.
struct LoadedFoam {
    Foam foam;
    std::vector<std::string> notes;  // remarks, for example on ignored parts, one line each
};

/// Checks the extension of a file name. The allowed extensions are .fe and .dmp for files of
/// Surface Evolver, and .json for a state of foamtex. Throws std::invalid_argument for any other
/// extension; the message lists the allowed ones.
void check_foam_name(const std::filesystem::path& path);

/// Reads a foam from a file. The extension selects the format. Throws InputError if the file cannot
/// be read, FormatError if it is malformed, and the exceptions of check_foam_name.
LoadedFoam load_foam(const std::filesystem::path& path);

/// Writes a foam atomically to a file (write_file). The extension selects the format. Throws
/// OutputError if the file cannot be written or the format cannot store the foam, and the
/// exceptions of check_foam_name.
void save_foam(const std::filesystem::path& path, const Foam& foam);

}  // namespace foam
