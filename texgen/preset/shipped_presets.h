// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <span>
#include <string_view>

namespace foam::texgen {

/// A preset that is part of the program.
struct ShippedPreset {
    std::string_view name;
    std::string_view toml;  // the whole file, comments included
};

/// Returns the files of presets/, which are embedded in the program.
std::span<const ShippedPreset> shipped_presets();

/// Returns the preset with a name. Throws PresetError if there is none; the error suggests a
/// similar name.
const ShippedPreset& find_shipped_preset(std::string_view name);

}  // namespace foam::texgen
