// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/preset/preset.h"

#include <filesystem>

namespace foam::texgen {

/// Returns a preset of 40 bubbles and images of 64 x 64 pixels, which is quick to bake. `pattern`
/// is the pattern of the file names.
inline Preset small_preset(const std::filesystem::path& pattern) {
    Preset preset;
    preset.name = "small";
    preset.description = "a small foam";
    preset.seeding.bubbles = 40;
    preset.seeding.seed = 12;
    preset.image.width = 64;
    preset.image.height = 64;
    preset.output.pattern = pattern.string();
    return preset;
}

}  // namespace foam::texgen
