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

/// Returns the torus of a seed. A seed gives the same parameters in every run:
/// - 20 to 5,000 bubbles, 0 to 5 iterations of Lloyd's algorithm, an aspect of 1/4 to 4
/// - the target areas of the diagram (one case in four), or a ratio of the largest to the smallest
///   target area of 1 to 100
/// - a T1 distance and a T2 area of 0.01 to 0.25, and kappa of 1e-3 to 1e3 (the paper's ranges)
/// - a frame_fraction of 0.3 % to 5 %, or of 1 % to 5 % for more than 1,000 bubbles
/// - in one case in ten, a frame_fraction of 50 %, which is far too long for one step
///
/// All ranges except the iterations are uniform in the logarithm.
FoamCase draw_case(std::uint64_t seed);

/// Returns the patch of a seed: the parameters of draw_case, and a random outline. The outline is a
/// star-shaped polygon of 3 to 16 corners, with spikes and bays. One outline in three has a hole,
/// which is a smaller copy of the outline.
FoamCase draw_patch(std::uint64_t seed);

/// Returns the raw diagram of the case.
Foam seed_case(const FoamCase& foam_case);

/// Returns the number of bubbles, including lone bubbles.
std::size_t bubbles_of(const Foam& foam);

/// Returns the foam time of a frame: the time in which a five-sided bubble loses frame_fraction of
/// the present mean area (E6).
double frame_time(const Foam& foam, const FoamCase& foam_case);

/// Returns all parameters that were drawn, in one line.
std::string describe(const FoamCase& foam_case);

}  // namespace foam::stress
