// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/image/comparison.h"
#include "texgen/image/difference_limits.h"

#include <span>

namespace foam::texgen {

/// The differences of all pixels of two pictures, row by row from the bottom row. `differences` has
/// the largest difference of the samples of each pixel. `angles` has the angle between the two
/// normals at each pixel, in degrees; it is empty if pixels are not compared as normals.
struct PixelDifferences {
    std::span<const double> differences;
    std::span<const double> angles;
};

/// Returns the smallest difference that at least `percent` percent of the pixels do not exceed (the
/// nearest-rank percentile). Preconditions: there is at least one pixel; `percent` is above 0 and
/// at most 100.
double percentile_of(std::span<const double> differences, double percent);

/// Compares the differences with the limits. Sets these members of `found`: pixels, warning_pixels,
/// failure_pixels, percentile, reasons and verdict. Preconditions: there is at least one pixel; the
/// members `largest` and `rms` of `found` are set.
void judge(const PixelDifferences& differences, const CompareLimits& limits, Comparison& found);

}  // namespace foam::texgen
