// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/preset/preset.h"

#include <cstdint>
#include <vector>

namespace foam::texgen {

/// Returns the estimated size, in bytes, of the files of a preset (images or vector files) for the
/// given frames. Files that exist are not counted, because a bake keeps or replaces them. The
/// estimate is usually right within a factor of 2; the size of an image file depends on how well
/// its pixels can be compressed.
/// Throws std::invalid_argument if the file pattern is malformed, and OutputError if the system
/// cannot tell whether a file exists.
std::uint64_t estimated_size(const Preset& preset, const std::vector<int>& frames);

}  // namespace foam::texgen
