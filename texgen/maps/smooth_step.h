// SPDX-License-Identifier: Apache-2.0

#pragma once

namespace foam::texgen {

/// Returns the smoothstep function 3 t² - 2 t³ of t = `passed`. It rises from 0 at t = 0 to 1 at
/// t = 1, and has the slope 0 at both ends.
template <class Number>
Number smooth_step(Number passed) {
    return passed * passed * (Number{3} - Number{2} * passed);
}

/// Returns the slope of smooth_step, 6 t - 6 t², at t = `passed`.
template <class Number>
Number smooth_step_slope(Number passed) {
    return Number{6} * passed * (Number{1} - passed);
}

}  // namespace foam::texgen
