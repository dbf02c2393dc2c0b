// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/image/comparison.h"
#include "texgen/image/difference_limits.h"

#include <span>

namespace foam::texgen {

/// The differences of all pixels of two pictures.
struct PixelDifferences {
    std::span<const double> differences;  // the largest difference of the samples of each pixel
    std::span<const double> angles;       // degrees, in the same order; empty without normals
};

/// Returns the smallest difference that at least `percent` percent of the pixels do not exceed (the
/// nearest-rank percentile). Preconditions: there is a pixel; `percent` is above 0 and at most 100.
double percentile_of(std::span<const double> differences, double percent);

/// Compares the differences with the limits. Stores the members of `found` that concern pixels and
/// limits: pixels, warning_pixels, failure_pixels, percentile, reasons, verdict. Its other members
/// must be known. Precondition: there is a pixel.
void judge(const PixelDifferences& differences, const CompareLimits& limits, Comparison& found);

}  // namespace foam::texgen
