// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/preset/preset.h"

#include <string>
#include <string_view>

namespace foam::texgen {

/// Returns true if the keys in a TOML table of presets influence the states of a simulation. The
/// result is false for the tables of maps and for the tables in the list kAppearanceTables in
/// simulation_keys.cpp, and true for all other tables. If a new table is not added to this list,
/// `render` therefore rejects changes of its keys. The functions below consider two special cases,
/// which this function ignores: the aspect ratio of the image, and the camera if events of a patch
/// have positions.
bool table_affects_simulation(std::string_view table);

/// Returns a hash (32 hexadecimal digits) of the version of foamtex and of everything in the preset
/// that influences the states of a simulation. The hash is written into every file of a cache. A
/// reader rejects files whose hash differs from the hash in cache.json, so that a cache never mixes
/// states of different simulations or versions. A cache that another version has written can be
/// read, because all of its files have the same hash.
std::string simulation_hash(const Preset& preset);

/// Returns a hash (32 hexadecimal digits) of the version of foamtex and of everything in the preset
/// that influences the values of a map, before they are converted to samples. The hash does not
/// contain the size of the images in pixels (only the aspect ratio, as in simulation_hash) or the
/// frames that are drawn; the caller adds them if they matter.
std::string drawing_hash(const Preset& preset, const Map& map);

/// Throws PresetError if the preset `changed` needs another simulation than the preset `simulated`.
/// The message names the key. Both presets must have the same values of all keys that influence the
/// states, the same events and, for a torus, the same aspect ratio. If events of a patch have
/// positions in the image, the camera and the aspect ratio must also be the same.
void check_same_simulation(const Preset& simulated, const Preset& changed);

}  // namespace foam::texgen
