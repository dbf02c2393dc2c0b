// SPDX-License-Identifier: Apache-2.0

#pragma once

namespace foam::texgen {

/// Returns the smoothstep function 3 t² - 2 t³. It rises from 0 at t = 0 to 1 at t = 1, and has the
/// slope 0 at both ends.
template <class Number>
Number smooth_step(Number t) {
    return t * t * (Number{3} - Number{2} * t);
}

/// Returns the slope of smooth_step, 6 t - 6 t².
template <class Number>
Number smooth_step_slope(Number t) {
    return Number{6} * t * (Number{1} - t);
}

}  // namespace foam::texgen
