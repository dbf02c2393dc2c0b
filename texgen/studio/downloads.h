// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/preset/preset.h"
#include "texgen/studio/frame_store.h"
#include "texgen/studio/http_message.h"
#include "texgen/studio/settings.h"

#include <optional>
#include <string>

namespace foam::texgen {

// The answers to /api/download (REQUESTS.md): files that the browser saves. All functions except
// preset_download let bake() draw frames. If the store keeps all frames of the preset, bake() takes
// the frames from the store; otherwise it simulates the foam again. These functions throw the
// exceptions of bake(), and SimulationFailed if the foam has no equilibrium or the loop does not
// close.

/// Returns a preset file with the settings (preset_file). `loaded` is the result of load_settings
/// for the same settings.
HttpResponse preset_download(const PageSettings& settings, const PagePreset& loaded);

/// Returns a frame of a map as the PNG that a bake writes.
HttpResponse frame_download(const Preset& preset,
                            const std::string& map,
                            int frame,
                            FrameStore& store);

/// Returns a frame as the SVG that a bake writes. If vector.content is "auto", the SVG shows the
/// maze or the contours of the map, or the foam if the map shows neither.
HttpResponse drawing_download(const Preset& preset,
                              const std::string& map,
                              int frame,
                              FrameStore& store);

/// Returns all frames of a map as an animated PNG. `side` is the largest width and height of the
/// pictures, in pixels (reduced_image); without it they have the size of the preset.
HttpResponse loop_download(Preset preset,
                           const std::string& map,
                           std::optional<int> side,
                           FrameStore& store);

}  // namespace foam::texgen
