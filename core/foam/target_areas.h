// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <span>

namespace foam {

/// Replaces the areas by areas from 1 to `ratio` whose logarithms are evenly spaced. The order by
/// size is kept: the largest area stays the largest.
void spread_areas(std::span<double> areas, double ratio);

/// Replaces the areas of cells by target areas. `field` contains the value of an area field at each
/// cell; it is empty if there is no field.
///
/// Without a field, applies spread_areas if `ratio` is positive, and does not change the areas if
/// `ratio` is 0.
///
/// With a field, makes two steps:
/// - If `ratio` is positive, divides each area by the value of the field at its cell and applies
///   spread_areas to the quotients. If `ratio` is 0, sets all areas to 1.
/// - Multiplies each area by the value of the field at its cell.
void set_target_areas(std::span<double> areas, std::span<const double> field, double ratio);

/// Scales the areas so that their sum is `total`.
void scale_to_total(std::span<double> areas, double total);

}  // namespace foam
