// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/preset/assignment.h"
#include "texgen/preset/preset.h"

#include <span>

namespace foam::texgen {

/// Checks that the loop is possible with the foam, the frames and the events of a preset. Throws
/// PresetError otherwise; the error names the last assignment that may be the cause.
void check_loop(const Preset& preset, std::span<const Assignment> assignments);

}  // namespace foam::texgen
