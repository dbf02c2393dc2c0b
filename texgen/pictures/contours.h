// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/geometry/vec2.h"
#include "texgen/image/image.h"

#include <vector>

namespace foam::texgen {

/// Returns the border of the region in which the numbers of a grid are at least `level`: closed
/// rings, with the region on their left. The grid is an image of one channel: sample (x, y) is the
/// number at the point (x, y) of the plane. Beyond the grid, all numbers count as 0. The last
/// corner of a ring is joined to the first. Numbers are interpolated linearly along the sides of
/// the squares of the grid (marching squares: W. E. Lorensen, H. E. Cline, "Marching cubes", 1987,
/// in two dimensions). Corners that would be nearer than 0.01 to a point of the grid are moved to
/// this distance. Therefore no ring crosses or touches itself or another ring.
/// Precondition: level > 0.
std::vector<std::vector<Vec2>> contours(const Image<float>& grid, double level);

}  // namespace foam::texgen
