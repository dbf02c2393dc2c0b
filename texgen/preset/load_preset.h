#pragma once

#include "texgen/preset/preset.h"

#include <string>

namespace foam::texgen {

/// An argument that ends with ".toml" or contains a '/' is a file, anything else the name of a
/// shipped preset. A preset may extend another, which is said first:
///
///     extends = "sea_foam"    # or a file, beside the one that says so
///
/// It then has all keys of the other but those that it sets itself, and the other's events unless
/// it has some. Throws PresetError, also for a file that is missing or unreadable, and where
/// presets extend each other in a circle.
Preset load_preset(const std::string& name_or_path);

}  // namespace foam::texgen
