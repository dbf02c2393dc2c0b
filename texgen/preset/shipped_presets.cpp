// SPDX-License-Identifier: Apache-2.0

#include "texgen/preset/shipped_presets.h"

#include "texgen/keys/nearest.h"
#include "texgen/preset/assignment.h"

#include <fmt/core.h>

#include <algorithm>
#include <vector>

namespace foam::texgen {

namespace {

std::string unknown_preset(std::string_view name) {
    std::vector<std::string_view> names;
    for (const ShippedPreset& preset : shipped_presets()) {
        names.push_back(preset.name);
    }
    std::string_view meant = nearest(name, names);
    if (meant.empty()) {
        meant = nearest(name.substr(0, name.find('.')), names);  // "lava" of "lava.tml"
    }
    return fmt::format("preset '{}': must be a .toml file or a name; {}",
                       name,
                       meant.empty() ? "'foamtex presets' lists all presets"
                                     : fmt::format("did you mean '{}'?", meant));
}

}  // namespace

const ShippedPreset& find_shipped_preset(std::string_view name) {
    const auto presets = shipped_presets();
    const auto found = std::find_if(
        presets.begin(), presets.end(), [&](const auto& preset) { return preset.name == name; });
    if (found == presets.end()) {
        throw PresetError(unknown_preset(name));
    }
    return *found;
}

}  // namespace foam::texgen
