// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/dynamics/step.h"
#include "core/foam/outline.h"
#include "core/foam/random.h"
#include "core/foam/seeding.h"

#include <cstdint>
#include <optional>
#include <string>

namespace foam::stress {

/// The parameters of a random foam and of its coarsening.
struct FoamCase {
    SeedingOptions seeding;          // seeding.seed is the seed of the whole case
    std::optional<Outline> outline;  // given for a patch; seeding.aspect is then unused
    StepOptions step;
    // The area that a five-sided bubble loses in a frame, as a fraction of the present mean area.
    double frame_fraction = 0.01;
};

/// Returns a random number, uniformly distributed in [low, high).
double uniform(Random& random, double low, double high);

/// Returns a random number in [low, high) whose logarithm is uniformly distributed. Precondition:
/// 0 < low <= high.
double log_uniform(Random& random, double low, double high);

/// Draws the torus of a seed. A seed gives the same parameters in every run:
/// - 20 to 5,000 bubbles, 0 to 5 iterations of Lloyd's algorithm, an aspect of 1/4 to 4
/// - target areas of the diagram itself (one case in four), or with a ratio of 1 to 100
/// - a T1 distance and a T2 area of 0.01 to 0.25, and kappa of 1e-3 to 1e3 (the paper's ranges)
/// - frames of 0.3 % to 5 % of the mean area, or of 1 % to 5 % for more than 1,000 bubbles
/// - in one case in ten, frames of 50 % of the mean area, which are far too long
///
/// All ranges except the iterations are uniform in the logarithm.
FoamCase draw_case(std::uint64_t seed);

/// Draws the patch of a seed: the parameters of draw_case, and a random outline. The outline is a
/// star-shaped polygon of 3 to 16 corners, with spikes and bays. One outline in three has a hole of
/// the same shape.
FoamCase draw_patch(std::uint64_t seed);

/// Returns the raw diagram of the case.
Foam seed_case(const FoamCase& foam_case);

/// Returns the number of bubbles, including lone bubbles.
std::size_t bubbles_of(const Foam& foam);

/// Returns the duration of a frame (E6) at the present mean area of the foam.
double frame_time(const Foam& foam, const FoamCase& foam_case);

/// Returns all parameters that were drawn, in one line.
std::string describe(const FoamCase& foam_case);

}  // namespace foam::stress
