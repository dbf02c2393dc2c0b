#pragma once

#include "core/foam/foam.h"

namespace foam {

/// Gas diffusion (E6; paper eq. 4 and 14).
struct CoarseningOptions {
    double kappa = 0.01;  // diffusion constant, foam units
};

/// Returns the rate of von Neumann's law: dA/dt = (2 pi / 3) gamma kappa (n - 6). In a patch n
/// counts the outer films, too: gas diffuses through all films, also to the ghost's pressure of 0.
double growth_rate(const Foam& foam, BubbleId bubble, const CoarseningOptions& options);

/// Returns the rate for a lone bubble, which has no junction: n = 0.
double lone_growth_rate(const Foam& foam, const CoarseningOptions& options);

/// Lets gas diffuse for a time: every target area grows at its rate. On a torus the total stays; a
/// patch loses gas to the ghost. The target of a bubble that should vanish may become negative.
void diffuse(Foam& foam, double time, const CoarseningOptions& options);

}  // namespace foam
