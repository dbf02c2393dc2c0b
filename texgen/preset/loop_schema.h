#pragma once

#include "texgen/preset/assignment.h"
#include "texgen/preset/schema.h"

#include <span>
#include <vector>

namespace foam::texgen {

/// The keys that say how an animation loops.
std::vector<Key> loop_keys();

/// Whether the loop can be had: of this kind of foam, with these frames, without events. Blames the
/// assignments that were made last. Throws PresetError.
void check_loop(const Preset& preset, std::span<const Assignment> assignments);

}  // namespace foam::texgen
