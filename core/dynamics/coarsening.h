// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/foam/foam.h"

namespace foam {

/// Options for gas diffusion (E6; paper eq. 4 and 14).
struct CoarseningOptions {
    double kappa = 0.01;  // diffusion constant (E6), in foam units
};

/// Returns the growth rate of a bubble's area by von Neumann's law:
/// dA/dt = (2 pi / 3) gamma kappa (n - 6). Here n is the number of sides, gamma is half of the film
/// tension, and kappa is the diffusion constant. In a patch n includes the outer films: gas also
/// diffuses through them, to the ghost at pressure 0.
double growth_rate(const Foam& foam, BubbleId bubble, const CoarseningOptions& options);

/// Returns the growth rate of the area of a lone bubble, which has no junction: n = 0.
double lone_growth_rate(const Foam& foam, const CoarseningOptions& options);

/// Lets gas diffuse for the given time: every target area changes at the growth rate of its bubble.
/// On a torus the sum of the target areas is unchanged; a patch loses gas to the ghost. The target
/// area of a bubble may become negative. Such a bubble has to vanish: collapse_due (collapse.h)
/// removes it or, if it cannot vanish, raises its target area.
void diffuse(Foam& foam, double time, const CoarseningOptions& options);

}  // namespace foam
