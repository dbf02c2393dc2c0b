// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/manifest/manifest.h"

#include <string>
#include <vector>

namespace foam::texgen {

/// Returns a set of one map, "height". The frames `asked` were requested, and the frames `existing`
/// have files.
inline BakedSet small_set(const std::string& preset,
                          const std::vector<int>& asked,
                          const std::vector<int>& existing) {
    BakedSet set{.version = "1.2.3",
                 .preset = preset,
                 .description = "a \"small\" foam",
                 .toml = "[foam]\nbubbles = 40\n",
                 .parameters = "of " + preset,
                 .seed = 12,
                 .width = 64,
                 .height = 32,
                 .frames_per_second = 24,
                 .loop = {"breathe", "a loop", 48, false, 1.5e-12},
                 .conventions = {"top to bottom", "down", "pixels", "up", 0.005},
                 .maps = {},
                 .files = {},
                 .frame_statistics = {},
                 .failure = {}};
    set.maps.push_back(
        {"height",
         "relief",
         "diameters",
         "y up",
         asked,
         MapSamples{"number", "Y", "uint16", "data", "none", std::array{-0.5, 1.0 / 3.0}}});
    for (const int frame : existing) {
        set.files.push_back({preset + "_height." + std::to_string(frame) + ".png",
                             {"height"},
                             frame,
                             1234,
                             std::string(32, 'a')});
        set.frame_statistics.push_back(
            {frame, true, 0.1 * frame, 40, 1.0, 2, 1, 1e-12, 2e-13, 0.25, 0.5});
    }
    return set;
}

/// Returns a manifest of two sets. The first one has a failure; the second one has no optional
/// members.
inline Manifest small_manifest() {
    Manifest manifest{{small_set("a", {1, 2, 3, 5}, {1, 3}), small_set("b", {7}, {7})}};
    manifest.sets[0].frame_statistics.front().mechanics =
        FrameMechanics{.strain = 0.25, .energy = 75.5, .stress = {1.0, -0.125, 0.75}};
    manifest.sets[0].frame_statistics.front().measurements =
        R"({"bubbles":{"area":[0.75,1.25],"elongation":[null,1.5]},"shear_modulus":null})";
    manifest.sets[0].failure = "the disk is full";
    manifest.sets[0].files.front().numbers = NumberExtent{-0.25, 0.5, 0.125};
    manifest.sets[0].files.front().displacement = 0.0625;
    manifest.sets[0].maps.front().samples->pixel_format = "R16_UNORM";
    manifest.sets[0].scenes = {{"a.usda", "usda", 123, "abc"}, {"sub/a.glb", "gltf", 0, ""}};
    manifest.sets[1].loop.closing_error.reset();
    manifest.sets[1].maps.front().note.clear();
    manifest.sets[1].maps.front().samples->range.reset();
    manifest.sets[1].maps.push_back({"film", "mask", "0 to 1", "", {7}, {}});
    return manifest;
}

}  // namespace foam::texgen
