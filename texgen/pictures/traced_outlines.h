// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/foam/outline.h"
#include "texgen/image/image.h"

#include <vector>

namespace foam::texgen {

/// The approximate largest number of points of a grid from which an outline is traced. A square
/// grid then has about 1448 points along its side.
inline constexpr double kOutlineGridPoints = 2097152.0;

/// Returns the region in which the numbers of a grid (contours.h) are at least `level`, as
/// outlines. There is one outline per connected part, with its holes; the largest part comes first.
/// Parts and holes that are smaller than a thousandth of the region are dropped. The rings of the
/// outlines are simplified by the algorithm of Douglas and Peucker. They deviate from the contours
/// by at most a quarter of the spacing of the grid. The result is empty if the region is empty.
/// Precondition: level > 0.
std::vector<foam::Outline> traced_outlines(const Image<float>& grid, double level);

}  // namespace foam::texgen
