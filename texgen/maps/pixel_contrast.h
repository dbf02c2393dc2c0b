// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/maps/pixel_neighbors.h"

#include <cstdint>
#include <span>
#include <vector>

namespace foam::texgen {

/// Returns the pixels whose light varies too strongly for one sample, as indices in ascending
/// order. These are the pixels that a film or wall may cross, and the pixels with a high contrast.
/// A pixel has a high contrast if its brightness differs too much from the mean of its two
/// neighbors in the row or in the column. `brightness` is from 0 to kWhite. `distances` are the
/// distances from films or walls on which the relief depends (Relief::distance), in pixels.
std::vector<std::uint32_t> find_contrasts(std::span<const float> brightness,
                                          std::span<const float> distances,
                                          const PixelNeighbors& neighbors);

}  // namespace foam::texgen
