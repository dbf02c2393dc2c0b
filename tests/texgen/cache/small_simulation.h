// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/files/file_io.h"
#include "tests/texgen/small_preset.h"
#include "texgen/cache/cache.h"
#include "texgen/maps/all_maps.h"

#include <filesystem>
#include <string>

namespace foam::texgen {

/// Returns a preset of a small coarsening foam with every map.
inline Preset all_maps_of_a_foam() {
    Preset preset = small_preset(Preset().output.pattern);
    preset.coarsening.kappa = 0.05;
    preset.image.width = 48;
    preset.image.height = 32;
    preset.frames.count = 6;
    const auto names = map_names();
    preset.image.maps.assign(names.begin(), names.end());
    return preset;
}

/// Reads a state of a cache. Returns the message of the InputError that this throws, or an empty
/// string.
inline std::string error_of(const std::filesystem::path& folder, int number) {
    try {
        Cache(folder).state(number);
    } catch (const InputError& error) {
        return error.what();
    }
    return "";
}

}  // namespace foam::texgen
