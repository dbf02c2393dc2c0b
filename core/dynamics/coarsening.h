// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/foam/foam.h"

namespace foam {

/// Options for gas diffusion (E6; paper eq. 4 and 14).
struct CoarseningOptions {
    double kappa = 0.01;  // diffusion constant, foam units
};

/// Returns the growth rate by von Neumann's law: dA/dt = (2 pi / 3) gamma kappa (n - 6). In a patch
/// n includes the outer films: gas also diffuses through them, to the ghost at pressure 0.
double growth_rate(const Foam& foam, BubbleId bubble, const CoarseningOptions& options);

/// Returns the growth rate of a lone bubble, which has no junction: n = 0.
double lone_growth_rate(const Foam& foam, const CoarseningOptions& options);

/// Lets gas diffuse for a time: every target area grows at its rate. On a torus the total is
/// unchanged; a patch loses gas to the ghost. The target area of a bubble that should vanish may
/// become negative until collapse_due (collapse.h) removes the bubble.
void diffuse(Foam& foam, double time, const CoarseningOptions& options);

}  // namespace foam
