// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/foam/outline.h"
#include "texgen/pictures/scalar_grid.h"

#include <vector>

namespace foam::texgen {

/// Returns the region in which the numbers of a grid are at least `level`, as outlines: one per
/// connected part, with its holes, the largest first. Parts and holes that are smaller than a
/// thousandth of the region are dropped. Rings are simplified by the algorithm of Douglas and
/// Peucker: they deviate from the contours by at most a quarter of the spacing of the grid. The
/// result is empty if the region is empty. Precondition: level > 0.
std::vector<foam::Outline> traced_outlines(const ScalarGrid& grid, double level);

}  // namespace foam::texgen
