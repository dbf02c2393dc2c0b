#pragma once

#include "texgen/preset/preset.h"

#include <span>
#include <string>
#include <string_view>

namespace foam::texgen {

/// A preset that is part of the program.
struct ShippedPreset {
    std::string_view name;
    std::string_view toml;  // the whole file, comments included
};

/// The files of presets/, embedded when the program was built.
std::span<const ShippedPreset> shipped_presets();

/// Throws PresetError that lists the names there are.
const ShippedPreset& find_shipped_preset(std::string_view name);

/// An argument that ends with ".toml" or contains a '/' is a file, anything else the name of a
/// shipped preset. Throws PresetError, also for a file that is missing or unreadable.
Preset load_preset(const std::string& name_or_path);

}  // namespace foam::texgen
