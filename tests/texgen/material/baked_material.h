// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "tests/support/temporary_folder.h"
#include "tests/texgen/small_preset.h"
#include "texgen/manifest/manifest_file.h"
#include "texgen/manifest/recorded_bake.h"
#include "texgen/material/scene_material.h"

#include <string>
#include <vector>

namespace foam::texgen {

/// Returns a preset of frames of 32 x 16 pixels with the given maps, whose name is no identifier.
inline Preset small_material(const TemporaryFolder& folder,
                             std::vector<std::string> maps,
                             const std::string& suffix = ".png") {
    Preset preset = small_preset(folder.path() / ("{map}.####" + suffix));
    preset.name = "my foam";
    preset.image.width = 32;
    preset.image.height = 16;
    preset.image.maps = std::move(maps);
    preset.maps.height.full = {0.5};
    preset.output.frames_per_second = 30;
    return preset;
}

/// Bakes frames of a preset and returns their material.
inline SceneMaterial baked_material(const Preset& preset,
                                    const TemporaryFolder& folder,
                                    const std::vector<int>& frames = {1, 2}) {
    bake_recorded(preset, {.frames = frames, .threads = 1}, {});
    return scene_material(preset, read_manifest(folder.path()).sets.back(), folder.path());
}

/// Returns how often a text contains another one.
inline int count_of(const std::string& text, const std::string& part) {
    int count = 0;
    for (std::size_t k = text.find(part); k != std::string::npos; k = text.find(part, k + 1)) {
        ++count;
    }
    return count;
}

}  // namespace foam::texgen
