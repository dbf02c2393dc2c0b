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

/// A foam and how it coarsens.
struct FoamCase {
    SeedingOptions seeding;          // seeding.seed is the seed of the whole case
    std::optional<Outline> outline;  // of a patch, which has no aspect
    StepOptions step;
    double frame_fraction =
        0.01;  // what a five-sided bubble loses in a frame, in present mean areas
};

/// Uniform in [low, high).
double uniform(Random& random, double low, double high);

/// Uniform in the logarithm over [low, high). Precondition: 0 < low <= high.
double log_uniform(Random& random, double low, double high);

/// The case of a seed, the same in every run: 20 to 5,000 bubbles; Lloyd 0 to 5; areas of the
/// diagram itself (one in four) or spread up to 100; aspects of 1/4 to 4; T1 distance and T2 area
/// of 0.01 to 0.25 and kappa of 1e-3 to 1e3, the paper's ranges; frames of 0.3 % to 5 % of the mean
/// area (1 % to 5 % of more than 1,000 bubbles), and far too long ones of 50 % (one in ten). All
/// but Lloyd uniform in the logarithm.
FoamCase draw_case(std::uint64_t seed);

/// The patch of a seed: the case of that seed within a random outline, a polygon of 3 to 16 corners
/// that is a star as seen from its middle, with spikes and bays; one in three has a hole of the
/// same shape.
FoamCase draw_patch(std::uint64_t seed);

/// The raw diagram of the case.
Foam seed_case(const FoamCase& foam_case);

/// Bubbles, lone ones included.
std::size_t bubbles_of(const Foam& foam);

/// The time of a frame (E6) at the foam's present mean area.
double frame_time(const Foam& foam, const FoamCase& foam_case);

/// Every parameter that was drawn, on a line.
std::string describe(const FoamCase& foam_case);

}  // namespace foam::stress
