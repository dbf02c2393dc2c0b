// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/dynamics/step.h"
#include "core/equilibrium/equilibrate.h"
#include "core/equilibrium/newton_system.h"
#include "core/foam/patch.h"
#include "core/foam/seeding.h"

#include <chrono>
#include <cstdint>
#include <map>
#include <memory>
#include <numbers>
#include <stdexcept>

namespace foam::bench {

/// Returns a raw diagram with the seed 1: the Voronoi diagram of random sites, without Lloyd
/// iterations and not in equilibrium.
inline Foam raw_foam(int bubbles) {
    return seed_foam({.bubbles = bubbles, .seed = 1});
}

/// Returns raw_foam(bubbles) in equilibrium. It is computed once for each number of bubbles.
inline const Foam& equilibrated_foam(int bubbles) {
    static std::map<int, Foam> foams;
    const auto [entry, is_new] = foams.try_emplace(bubbles);
    if (is_new) {
        entry->second = raw_foam(bubbles);
        equilibrate(entry->second, {});
    }
    return entry->second;
}

/// Returns the raw diagram of a free patch with the outline of a disc.
inline Foam raw_patch(int bubbles, std::uint64_t seed) {
    return seed_patch(disc_outline(), {.bubbles = bubbles, .seed = seed});
}

/// Returns the foam time of a frame: the time in which the area of a bubble of five or seven sides
/// changes by 1 % of the mean area (E6).
inline double ordinary_frame_time(const Foam& foam, const CoarseningOptions& coarsening) {
    double total = 0.0;
    for (const BubbleId bubble : foam.network.bubbles()) {
        total += foam.target_areas[bubble];
    }
    const double mean_area = total / static_cast<double>(foam.network.bubble_count());
    const double gamma = 0.5 * foam.film_tension;
    return 0.01 * mean_area / (2.0 * std::numbers::pi / 3.0 * gamma * coarsening.kappa);
}

/// Makes coarsening frames of a foam in equilibrium, and returns the mean wall time of a frame, in
/// seconds. All frames share a linear system, as in an animation. Throws std::runtime_error if an
/// equilibrium is not found.
inline double mean_frame_seconds(Foam& foam, int frames) {
    using Clock = std::chrono::steady_clock;
    StepOptions options;
    options.equilibrium.system = std::make_shared<NewtonSystem>();
    const Clock::time_point begin = Clock::now();
    for (int frame = 0; frame < frames; ++frame) {
        if (!step(foam, ordinary_frame_time(foam, {}), options).equilibrium.converged()) {
            throw std::runtime_error("no equilibrium");
        }
    }
    return std::chrono::duration<double>(Clock::now() - begin).count() / frames;
}

}  // namespace foam::bench
