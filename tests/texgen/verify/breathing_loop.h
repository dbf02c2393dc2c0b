// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "tests/texgen/small_preset.h"
#include "texgen/manifest/recorded_bake.h"

#include <filesystem>
#include <vector>

namespace foam::texgen {

/// Returns a preset of a small loop of 8 frames.
inline Preset breathing_loop(const std::filesystem::path& folder) {
    Preset preset = small_preset(folder / "{map}.####.png");
    preset.image.maps = {"albedo", "height", "id"};
    preset.frames.count = 8;
    preset.loop.kind = LoopKind::Breathe;
    return preset;
}

/// Bakes these frames and writes a manifest.
inline void bake_small(const Preset& preset, const std::vector<int>& frames) {
    bake_recorded(preset, {.frames = frames, .threads = 1}, {});
}

}  // namespace foam::texgen
