// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <span>

namespace foam {

/// Replaces the areas by areas from 1 to `ratio` whose logarithms are evenly spaced. The order by
/// size is kept: the largest area stays the largest.
void spread_areas(std::span<double> areas, double ratio);

/// Scales the areas so that their sum is `total`.
void scale_to_total(std::span<double> areas, double total);

}  // namespace foam
