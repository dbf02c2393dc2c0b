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
    std::vector<std::string> notes;  // contents of the file that a Foam cannot hold, one line each
};

/// Throws std::invalid_argument, whose message lists the allowed extensions, unless the name ends
/// in one of them: .fe and .dmp are files of Surface Evolver, .json is a state of foamtex.
void check_foam_name(const std::filesystem::path& path);

/// Reads a foam from a file. Throws as check_foam_name, InputError if the file cannot be read, and
/// FormatError if it is malformed.
LoadedFoam load_foam(const std::filesystem::path& path);

/// Writes a foam to a file, atomically as write_file does. Throws as check_foam_name, and
/// OutputError if the file cannot be written.
void save_foam(const std::filesystem::path& path, const Foam& foam);

}  // namespace foam::texgen
