// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <span>
#include <string_view>

namespace foam::texgen {

/// A preset that is part of the program.
struct ShippedPreset {
    std::string_view name;
    std::string_view toml;  // the whole file, comments included
    // The content of presets/loops/NAME.json: a state from which the loop of the preset closes in
    // its next cycle. The program therefore need not search for such a state
    // (animation/loop_start.h). The text is empty if there is no such file.
    std::string_view loop_start{};
};

/// Returns all presets that are part of the program. CMake embeds them from the files of presets/.
std::span<const ShippedPreset> shipped_presets();

/// Returns the preset with the given name. Throws PresetError if there is none; the message
/// suggests a similar name if one exists.
const ShippedPreset& find_shipped_preset(std::string_view name);

}  // namespace foam::texgen
