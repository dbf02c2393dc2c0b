// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/maps/pixel_neighbors.h"

#include <cstdint>
#include <span>
#include <vector>

namespace foam::texgen {

/// Returns the pixels whose light varies too strongly for one sample, as indices in ascending
/// order: those that a film may cross, and those whose brightness differs by more than a threshold
/// from the mean of the two neighbors in a row or in a column. `brightness` is from 0 to kWhite,
/// and `distances` are the distances to the nearest film, in pixels.
std::vector<std::uint32_t> find_contrasts(std::span<const float> brightness,
                                          std::span<const float> distances,
                                          const PixelNeighbors& neighbors);

}  // namespace foam::texgen
