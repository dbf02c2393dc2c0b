// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/foam/measure.h"
#include "tests/stress/foam_case.h"

#include <cstddef>
#include <optional>
#include <string>

namespace foam::stress {

struct LifeOptions {
    int max_frames = 0;       // ends the life early; 0: no limit
    double tolerance = 1e-6;  // largest area (relative) and angle (radians) error of a frame
    bool verbose = false;     // a line per frame on stderr
};

/// What went wrong, and in which frame: 0 is the equilibrium of the seeded foam.
struct LifeFailure {
    int frame = 0;
    std::string reason;
    Foam before;  // the foam as the frame found it, for a state file; empty if seeding failed
};

/// How a foam lived, in sums over its frames.
struct LifeSummary {
    int frames = 0;
    int substeps = 0;
    int t1 = 0;
    int t2 = 0;
    std::size_t bubbles_left = 0;
    EquilibriumErrors worst;
    double seconds = 0.0;  // of processor time
    std::optional<LifeFailure> failure;
};

/// Seeds the foam, brings it to equilibrium and lets it coarsen to its end: a torus until four
/// bubbles are left, or only six-sided ones, which keep their areas for ever, a patch until it has
/// lost all its gas. Examines the foam after every
/// frame and stops at the first failure; an exception is one too, and so is a foam of which no
/// bubble vanishes in the time in which a hundred mean areas diffuse.
LifeSummary live(const FoamCase& foam_case, const LifeOptions& options);

/// What became of it, on a line.
std::string describe(const LifeSummary& summary);

}  // namespace foam::stress
