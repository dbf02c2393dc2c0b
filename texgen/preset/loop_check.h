// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/preset/assignment.h"
#include "texgen/preset/preset.h"

#include <span>

namespace foam::texgen {

/// Checks that the loop of a preset is possible with its foam, its frames and its events. Throws
/// PresetError otherwise; the message names an assignment that may be the cause. Precondition: the
/// assignments have been stored in the preset.
void check_loop(const Preset& preset, std::span<const Assignment> assignments);

}  // namespace foam::texgen
