// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <span>

namespace foam {

/// Replaces the areas by areas from 1 to `ratio` whose logarithms are evenly spaced. The order by
/// size is kept: the largest area stays the largest.
void spread_areas(std::span<double> areas, double ratio);

/// Turns the areas of cells into target areas. `field` has the area of an area field at each cell,
/// or is empty if there is none. If `ratio` is positive, the areas become areas from 1 to `ratio`
/// (spread_areas), in the order of the areas relative to the field. If `ratio` is 0, the areas stay
/// as they are if there is no field, and become equal otherwise. If there is a field, each area is
/// finally multiplied by the area of the field at its cell.
void set_target_areas(std::span<double> areas, std::span<const double> field, double ratio);

/// Scales the areas so that their sum is `total`.
void scale_to_total(std::span<double> areas, double total);

}  // namespace foam
