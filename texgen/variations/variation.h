// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/preset/preset.h"
#include "texgen/variations/sweep.h"

#include <span>
#include <vector>

namespace foam::texgen {

/// The values of some keys, each key at most once, which replace the values in a preset.
struct Variation {
    std::vector<Assignment> assignments;
};

/// Returns all combinations of the values of sweeps. The values of the last sweep vary fastest.
/// Throws PresetError if two sweeps have the same key, or if there are more than kMaxValues
/// combinations. Precondition: there is a sweep.
std::vector<Variation> variations_of(std::span<const Sweep> sweeps);

/// Returns the preset of each variation. Throws PresetError if a value is not allowed.
std::vector<Preset> presets_of(const Preset& preset, std::span<const Variation> variations);

}  // namespace foam::texgen
