// SPDX-License-Identifier: Apache-2.0

#include "core/geometry/exponential.h"

#include <cmath>

namespace foam::ieee {

double pow(double x, double y) {
    const double power = pow_of_positive(magnitude(x), y);
    if (!std::signbit(x) || std::isinf(y)) {
        return power;
    }
    const bool is_odd = std::fmod(y, 2.0) == 1.0 || std::fmod(y, 2.0) == -1.0;
    const bool is_whole = std::fmod(y, 1.0) == 0.0;
    const bool is_defined = is_whole || x == 0.0 || std::isinf(x);
    return is_odd ? -power : is_defined ? power : detail::kNaN;
}

}  // namespace foam::ieee
