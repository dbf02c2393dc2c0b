// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/keys/key.h"
#include "texgen/preset/assignment.h"
#include "texgen/preset/preset.h"

#include <span>
#include <string>
#include <vector>

namespace foam::texgen {

/// Returns true if the preset meets a condition on the value of one of its keys.
bool is_met(const Condition& condition, const Preset& preset);

/// Returns a line for each key that the assignments set although it has no effect in the preset. An
/// example of a line is: relief.angle has no effect with relief.profile = "wet". Precondition: the
/// assignments have been stored in the preset.
std::vector<std::string> unused_keys(const Preset& preset, std::span<const Assignment> assignments);

/// Returns the lines that `foamtex presets keys` prints about the conditions of a key; empty if the
/// key has no conditions.
std::string describe_conditions(const KeyInfo& key);

}  // namespace foam::texgen
