// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/preset/preset.h"

#include <string>
#include <string_view>

namespace foam::texgen {

/// Returns true if the keys in a TOML table of presets influence the states of a simulation. The
/// result is false for the tables of maps and for the tables in the list kAppearanceTables in
/// simulation_keys.cpp, and true for all other tables. A new table therefore counts as influencing
/// the states, and `render` rejects changes of its keys, until the table is added to this list. Two
/// special cases are not considered here, but in simulation_hash and check_same_simulation: the
/// aspect ratio of the image, and the camera if events of a patch have positions.
bool table_affects_simulation(std::string_view table);

/// Returns a hash of the version of foamtex and of everything in the preset that influences the
/// states of a simulation. The hash is written into every file of a cache. A reader rejects files
/// whose hash differs from the hash in cache.json, so that a cache never mixes states of different
/// simulations or versions. A cache that another version has written completely can be read.
std::string simulation_hash(const Preset& preset);

/// Throws PresetError if the changed preset needs another simulation. The message names the key.
/// Both presets must have the same values of all keys that influence the states, the same events
/// and, for a torus, the same aspect ratio. If events of a patch have positions in the image, the
/// camera and the aspect ratio must also be the same.
void check_same_simulation(const Preset& simulated, const Preset& changed);

}  // namespace foam::texgen
