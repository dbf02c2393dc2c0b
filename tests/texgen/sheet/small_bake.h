// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "tests/texgen/small_preset.h"
#include "texgen/bake/frame_range.h"
#include "texgen/manifest/bake_recorder.h"
#include "texgen/manifest/manifest_file.h"
#include "texgen/manifest/recorded_bake.h"
#include "texgen/manifest/set_choice.h"

#include <filesystem>
#include <string>
#include <vector>

namespace foam::texgen {

/// Returns a preset of a loop of 4 frames of 32 x 24 pixels. Its files have names such as
/// small_albedo.0001.png.
inline Preset small_loop(const std::filesystem::path& folder, const char* extension = ".png") {
    Preset preset;
    preset.name = "small";
    preset.seeding.bubbles = 12;
    preset.frames.count = 4;
    preset.loop.kind = LoopKind::Drift;
    preset.loop.drift = {1, 0};
    preset.image.width = 32;
    preset.image.height = 24;
    preset.output.pattern = (folder / "{preset}_{map}.####").string() + extension;
    return preset;
}

/// Returns a preset of a patch, whose frames do not tile.
inline Preset small_patch(const std::filesystem::path& folder) {
    Preset preset = small_loop(folder);
    preset.loop = {};
    preset.shape.kind = FoamKind::Patch;
    return preset;
}

/// Bakes all frames of a preset with these maps. Returns the set in the manifest.
inline BakedSet baked(const Preset& preset, const std::vector<std::string>& maps) {
    Preset more = preset;
    more.image.maps = maps;
    bake_recorded(more, {.frames = frames_to(preset.frames.count), .threads = 1}, {});
    const std::filesystem::path folder = manifest_folder(more);
    return newest_set(read_manifest(folder), {.preset = more.name}, folder);
}

}  // namespace foam::texgen
