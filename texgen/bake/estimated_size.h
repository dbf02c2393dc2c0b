// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/preset/preset.h"

#include <cstdint>
#include <vector>

namespace foam::texgen {

/// Returns the estimated size, in bytes, of the image files of a preset for the given frames. Files
/// that exist are not counted, because a bake keeps or replaces them. The estimate is usually right
/// within a factor of 2. It is not exact, because sizes depend on how well the pixels can be
/// compressed.
std::uint64_t estimated_size(const Preset& preset, const std::vector<int>& frames);

}  // namespace foam::texgen
