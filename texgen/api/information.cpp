// SPDX-License-Identifier: Apache-2.0

#include "texgen/maps/all_maps.h"
#include "texgen/preset/algorithm_version.h"
#include "texgen/preset/preset_schema.h"
#include "texgen/preset/shipped_presets.h"

#include <foamtex/texture.h>

namespace foamtex {

std::string version() {
    return FOAMTEX_VERSION;
}

int algorithm_version() {
    return foam::texgen::kAlgorithmVersion;
}

std::vector<std::string> preset_names() {
    std::vector<std::string> names;
    for (const foam::texgen::ShippedPreset& preset : foam::texgen::shipped_presets()) {
        names.emplace_back(preset.name);
    }
    return names;
}

std::string key_schema() {
    return foam::texgen::preset_schema();
}

std::vector<MapInfo> maps() {
    std::vector<MapInfo> all;
    for (const foam::texgen::Map& map : foam::texgen::all_maps()) {
        all.push_back({std::string(map.name),
                       std::string(map.meaning),
                       std::string(map.unit),
                       std::string(map.channels)});
    }
    return all;
}

}  // namespace foamtex
