// SPDX-License-Identifier: Apache-2.0

#include "texgen/maps/identity_number.h"

#include <cmath>

namespace foam::texgen {

double identity_number(BubbleIdentity identity, IdentityStream stream) {
    constexpr double kFirstStep = 0.7548776662466927;
    constexpr double kSecondStep = 0.5698402909980532;
    const double multiple =
        (identity + 1.0) * (stream == IdentityStream::First ? kFirstStep : kSecondStep);
    return multiple - std::floor(multiple);
}

}  // namespace foam::texgen
