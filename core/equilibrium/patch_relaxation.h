#pragma once

#include "core/equilibrium/relaxation.h"

namespace foam {

/// Relaxation of a patch, or of a part of one (E4): its films are arcs from the start, each with a
/// half angle of its own. Nothing holds a patch but the pressures themselves, and the outer films
/// of small rafts are far from straight.
RelaxationSummary relax_patch(Foam& foam, Unknowns part, const RelaxationOptions& options);

}  // namespace foam
