#pragma once

#include "core/foam/foam.h"

namespace foam {

/// Gas diffusion (E6; paper eq. 4 and 14).
struct CoarseningOptions {
    double kappa = 0.01;  // diffusion constant, foam units
};

/// von Neumann's law: dA/dt = (2 pi / 3) gamma kappa (n - 6). In a patch n counts the outer films
/// as well: that is what comes through all films, those to the ghost's pressure of 0 among them.
double growth_rate(const Foam& foam, BubbleId bubble, const CoarseningOptions& options);

/// The same for a lone bubble, which has no junction: n = 0.
double lone_growth_rate(const Foam& foam, const CoarseningOptions& options);

/// Lets gas diffuse for a time: every target area grows at its rate. On a torus the total stays, a
/// patch loses gas to the ghost; the target of a bubble that should vanish may come out negative.
void diffuse(Foam& foam, double time, const CoarseningOptions& options);

}  // namespace foam
