#pragma once

#include <span>

namespace foam {

/// Sets areas that are spread evenly in the logarithm, the largest over the smallest being a ratio,
/// given out in the order of the present ones: the largest stays the largest.
void spread_areas(std::span<double> areas, double ratio);

/// Makes them add up to a total.
void scale_to_total(std::span<double> areas, double total);

}  // namespace foam
