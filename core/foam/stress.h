// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/foam/frame.h"

namespace foam {

/// Returns the integral of t tᵀ along an arc, where t is the unit tangent (E11). Its trace is the
/// length of the arc. Returns 0 if the chord is zero.
Mat2 tangent_integral(const FilmArc& arc);

/// Returns the mean stress of a foam (E11), in units of film tension per foam unit: the tension of
/// the films minus the pressure of the gas, averaged over the area of all bubbles. Tension is
/// positive. On a torus, the pressures and therefore the isotropic part are determined only up to a
/// common constant; the other parts are the derivatives of the energy per area with respect to
/// strain. In a patch in equilibrium, the mean stress is 0. Returns 0 for a foam without bubbles.
Mat2 stress(const Frame& frame);

}  // namespace foam
