// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/json/json_value.h"
#include "texgen/preset/preset.h"
#include "texgen/studio/folder.h"
#include "texgen/studio/settings.h"

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace foam::texgen {

/// A bake that a page asks for.
struct BakeRequest {
    PageSettings settings;
    std::string folder;                      // a path relative to the folder of the studio
    std::optional<std::string> frames = {};  // a range (parse_frame_range); all frames if missing
    std::string format = "png";              // the suffix of the images without the dot
    // The name of a shipped profile. If it is given, `maps` and `format` have no effect.
    std::optional<std::string> profile = {};
    std::vector<std::string> maps = {};           // if empty, the maps of the preset
    std::optional<std::array<int, 2>> size = {};  // width and height; the preset's size if missing
    bool resume = false;  // true if images of an earlier, stopped bake are kept (Resume)
};

/// Reads the members of a request. Throws InputError if one is malformed.
BakeRequest read_bake_request(const JsonValue& request);

/// A bake, ready to run.
struct BakePlan {
    Preset preset;
    std::vector<int> frames = {};
    // The command that bakes the same images in a terminal (bake_command); empty if no command line
    // can express the settings.
    std::string command = {};
};

/// Prepares a bake. Its images, sheets and scenes are written below the folder that the request
/// names. Throws SettingsRejected, PathRejected, and the exceptions of parse_frame_range.
BakePlan plan_of(const BakeRequest& request, const StudioFolder& folder);

}  // namespace foam::texgen
