#pragma once

#include "core/foam/foam.h"

namespace foam {

/// Simple shear of the whole foam along x: every point moves to the right by the strain times its
/// height, the torus with it. Areas stay; the foam is left out of equilibrium by the strain. The
/// lattice is reduced where its shear passes half a width.
void shear(Foam& foam, double strain);

/// Brings the shear of the torus into [-width/2, width/2] by whole widths: the same lattice by
/// other periods, so that nothing moves; lattice offsets are adapted.
void reduce_lattice(Foam& foam);

}  // namespace foam
