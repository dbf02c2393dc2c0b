// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <cmath>

namespace foam {

/// Returns the larger number, or NaN if either number is NaN. The largest of several errors,
/// computed with this function, is therefore NaN if one of the errors is NaN. std::max(a, b) would
/// ignore a NaN in b.
inline double max_or_nan(double a, double b) {
    return b > a || std::isnan(b) ? b : a;
}

}  // namespace foam
