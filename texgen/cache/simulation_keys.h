// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/preset/preset.h"

#include <string>
#include <string_view>

namespace foam::texgen {

/// Returns true if the keys in a TOML table of presets influence the states of a simulation. This
/// holds for every table except those that simulation_keys.cpp and map_keys list as affecting only
/// how states are drawn. Therefore `render` rejects changes to a new table until it is listed.
bool table_affects_simulation(std::string_view table);

/// Returns a hash of everything that influences the states of a simulation, and of the version of
/// foamtex. The hash is written into every file of a cache. A reader rejects files whose hash
/// differs from the one in cache.json.
std::string simulation_hash(const Preset& preset);

/// Throws PresetError if the changed preset needs another simulation. The message names the key. A
/// key that influences the states, the events and the aspect ratio of a torus must be the same. If
/// events of a patch have positions in the image, its camera and aspect ratio must be the same,
/// too.
void check_same_simulation(const Preset& simulated, const Preset& changed);

}  // namespace foam::texgen
