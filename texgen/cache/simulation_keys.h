// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/preset/preset.h"

#include <string>
#include <string_view>

namespace foam::texgen {

/// Returns true if the keys of a table of presets influence the states of a simulation. Every table
/// does, unless it is listed as one that only influences how states are drawn. Therefore a new
/// table cannot be changed by `render` until it is listed.
bool table_affects_simulation(std::string_view table);

/// Returns a hash of everything that influences the states of a simulation, and of the version of
/// foamtex. It is written into every file of a cache. A reader rejects files whose hash differs
/// from the one in cache.json.
std::string simulation_hash(const Preset& preset);

/// Throws PresetError, whose message names the key, if the changed preset needs another simulation:
/// if a key that influences the states differs, or the events, or the aspect ratio of a torus. If
/// events of a patch have positions in the image, its camera and its aspect ratio must not differ
/// either.
void check_same_simulation(const Preset& simulated, const Preset& changed);

}  // namespace foam::texgen
