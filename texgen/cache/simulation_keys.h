#pragma once

#include "texgen/preset/preset.h"

#include <string>

namespace foam::texgen {

/// A hash of all that decides the states of a simulation, and of the version of foamtex.
std::string simulation_hash(const Preset& preset);

/// Throws PresetError, naming the key, where a preset that was changed would be simulated in
/// another way than it was: what foam, dynamics, frames, loop and events say, the shape of a torus,
/// and, where the events of a patch have places in the image, what the camera shows.
void check_same_simulation(const Preset& simulated, const Preset& changed);

}  // namespace foam::texgen
