#pragma once

#include "texgen/preset/preset.h"

#include <string>

namespace foam::texgen {

/// Loads a preset. An argument that ends with ".toml" or contains a '/' is a file, anything else
/// the name of a shipped preset. A preset may begin by extending another:
///
///     extends = "sea_foam"    # or a file, relative to this one
///
/// It then has all values of the other except those that it sets, and the other's events unless it
/// has its own. Throws PresetError, also for a file that is missing or unreadable, and if presets
/// extend each other in a circle.
Preset load_preset(const std::string& name_or_path);

}  // namespace foam::texgen
