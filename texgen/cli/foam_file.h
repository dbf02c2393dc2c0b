#pragma once

#include "core/foam/foam.h"

#include <filesystem>
#include <string>
#include <vector>

namespace foam::texgen {

/// A foam and what of its file a foam has not, one line each.
struct LoadedFoam {
    Foam foam;
    std::vector<std::string> notes;
};

/// Throws std::invalid_argument, naming the extensions there are, unless the name ends in one:
/// .fe and .dmp are Surface Evolver's, .json is our own state.
void check_foam_name(const std::filesystem::path& path);

/// Throws as check_foam_name, InputError where the file cannot be read, FormatError where it is
/// malformed.
LoadedFoam load_foam(const std::filesystem::path& path);

/// All or nothing, as write_file. Throws as check_foam_name, and OutputError.
void save_foam(const std::filesystem::path& path, const Foam& foam);

}  // namespace foam::texgen
