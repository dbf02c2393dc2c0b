#pragma once

#include "texgen/preset/assignment.h"
#include "texgen/preset/schema.h"

#include <span>
#include <vector>

namespace foam::texgen {

/// The keys that say how maps are drawn: a table for every map that has some.
std::vector<Key> map_keys();

/// Those of them for what bubbles and films look like, in albedo and under a light.
std::vector<Key> look_keys();

/// Those of them for maps of what is at a place, not of a whole bubble.
std::vector<Key> place_map_keys();

/// What ties keys of maps together: low ends are below high ends. Blames the assignments that were
/// made last. Throws PresetError.
void check_maps(const Preset& preset, std::span<const Assignment> assignments);

}  // namespace foam::texgen
