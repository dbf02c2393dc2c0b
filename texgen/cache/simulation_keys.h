#pragma once

#include "texgen/preset/preset.h"

#include <string>
#include <string_view>

namespace foam::texgen {

/// Returns true if the keys of a table of presets decide the states of a simulation. A table does,
/// unless it is listed as one that decides only how states look: a table that nobody has thought of
/// here cannot be changed at a render.
bool decides_simulation(std::string_view table);

/// Returns a hash of everything that decides the states of a simulation, and of the version of
/// foamtex. It is written into every file of a cache, and a reader rejects files of another
/// simulation than that of cache.json.
std::string simulation_hash(const Preset& preset);

/// Throws PresetError, which names the key, if the changed preset needs another simulation: one of
/// its deciding keys or its events differ, or the shape of its torus, or, if events of a patch have
/// positions in the image, its camera.
void check_same_simulation(const Preset& simulated, const Preset& changed);

}  // namespace foam::texgen
