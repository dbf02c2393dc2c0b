#pragma once

#include <span>
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

}  // namespace foam::texgen
