// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/raster/simd/kernel.h"

namespace foam::texgen {

/// Interpolates linearly between the entries of a table. `position` is an index that need not be
/// whole; positions above `last`, the index of the last entry, count as `last`. Loops that call
/// this function can be vectorized. Preconditions: `position` is not negative, and `last` is at
/// least 1.
inline double looked_up(const double* table, int last, double position) {
    const double step = min_value(position, static_cast<double>(last));
    const int below = min_value(static_cast<int>(step), last - 1);
    return table[below] + (table[below + 1] - table[below]) * (step - below);
}

}  // namespace foam::texgen
