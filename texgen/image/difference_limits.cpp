// SPDX-License-Identifier: Apache-2.0

#include "texgen/image/difference_limits.h"

#include <algorithm>
#include <limits>

namespace foam::texgen {

double DifferenceLimits::sample_limit(bool has_normals) const {
    const bool has_others = rms || !percentiles.empty() || (angle && has_normals);
    return sample.value_or(has_others ? std::numeric_limits<double>::infinity()
                                      : kDefaultSampleLimit);
}

std::size_t DifferenceLimits::allowed_of(std::size_t pixels) const {
    // Rounding must not take away a pixel: 29 % of 100 pixels are 28.999999999999996 in doubles.
    constexpr double kRounding = 1e-12;
    const double share = allowed_percent / 100.0 * static_cast<double>(pixels);
    return std::max(static_cast<std::size_t>(allowed_pixels),
                    static_cast<std::size_t>(share * (1.0 + kRounding)));
}

}  // namespace foam::texgen
