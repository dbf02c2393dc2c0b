// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/foam/measure.h"
#include "tests/stress/foam_case.h"

#include <cstddef>
#include <optional>
#include <string>

namespace foam::stress {

/// Options of `live`. The life of a foam is its coarsening from a raw diagram to its end.
struct LifeOptions {
    int max_frames = 0;       // largest number of frames; 0 for no limit
    double tolerance = 1e-6;  // largest relative area error and angle error (radians)
    bool verbose = false;     // prints a line per frame on stderr
};

/// The failure of a foam. Frame 0 is the equilibrium of the seeded foam.
struct LifeFailure {
    int frame = 0;
    std::string reason;
};

/// The result of a life: sums and largest errors over its frames.
struct LifeSummary {
    int frames = 0;
    int substeps = 0;
    int t1 = 0;
    int t2 = 0;
    std::size_t bubbles_left = 0;
    EquilibriumErrors worst;  // largest errors of all frames; only area and angle are set
    double seconds = 0.0;     // processor time
    std::optional<LifeFailure> failure;
};

/// Seeds the foam, brings it to equilibrium and lets it coarsen to its end. A torus ends when at
/// most four bubbles are left, or when all bubbles have six sides and so keep their areas forever.
/// A patch ends when it has lost all its gas. Examines the foam in every frame and stops at the
/// first failure. An exception is a failure. It is also a failure if no bubble vanishes in the time
/// in which a five-sided bubble would lose a hundred mean areas.
LifeSummary live(const FoamCase& foam_case, const LifeOptions& options);

/// Returns the result in one line.
std::string describe(const LifeSummary& summary);

}  // namespace foam::stress
