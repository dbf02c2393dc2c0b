// SPDX-License-Identifier: Apache-2.0

#include "tests/stress/soundness.h"

#include "core/network/validate.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace foam::stress {

namespace {

constexpr double kTotalTolerance = 1e-9;  // relative to the area of the torus

bool all_finite(const Foam& foam) {
    const auto finite = [](double value) { return std::isfinite(value); };
    return std::isfinite(foam.time) &&
           std::all_of(foam.positions.begin(),
                       foam.positions.end(),
                       [](const Vec2& p) { return p.allFinite(); }) &&
           std::all_of(foam.pressures.begin(), foam.pressures.end(), finite) &&
           std::all_of(foam.half_angles.begin(), foam.half_angles.end(), finite);
}

std::optional<std::string> find_target_fault(const Foam& foam) {
    double total = 0.0;
    for (const BubbleId bubble : foam.network.bubbles()) {
        const double target = foam.target_areas[bubble];
        if (!(target > 0.0 && std::isfinite(target))) {
            return fmt::format("bubble {} has a target area of {:.3g}", index_of(bubble), target);
        }
        total += target;
    }
    for (const LoneBubble& bubble : foam.lone_bubbles) {
        if (!(bubble.target_area > 0.0)) {
            return fmt::format("a lone bubble has a target area of {:.3g}", bubble.target_area);
        }
    }
    if (foam.domain.is_plane()) {
        return std::nullopt;
    }
    const double error = std::abs(total / foam.domain.area() - 1.0);
    if (error > kTotalTolerance) {
        return fmt::format("the target areas miss the torus' area by {:.3g} of it", error);
    }
    return std::nullopt;
}

std::optional<std::string> find_error(const Foam& foam, double tolerance) {
    const EquilibriumErrors errors = equilibrium_errors(foam);
    if (!(errors.area <= tolerance)) {
        return fmt::format("an area error of {:.3g}", errors.area);
    }
    if (!(errors.angle <= tolerance)) {
        return fmt::format("an angle error of {:.3g}", errors.angle);
    }
    if (!(errors.arc <= tolerance)) {
        return fmt::format("an outer film that misses Laplace-Young's law by {:.3g}", errors.arc);
    }
    if (errors.films_at_limit > 0) {
        return fmt::format("{} films at the largest half angle", errors.films_at_limit);
    }
    return std::nullopt;
}

// Returns an error message if the energy of a patch differs from 2 sum p A (E3).
std::optional<std::string> find_work_error(const Foam& foam, double tolerance) {
    double work = 0.0;
    for (const BubbleId bubble : foam.network.bubbles()) {
        work += 2.0 * foam.pressures[bubble] * foam.target_areas[bubble];
    }
    for (const LoneBubble& bubble : foam.lone_bubbles) {
        work += 2.0 * foam.film_tension / lone_radius(bubble) * bubble.target_area;
    }
    const double total = energy(foam);
    if (!(std::abs(work - total) <= tolerance * total)) {
        return fmt::format("an energy of {:.9g}, but 2 sum p A = {:.9g}", total, work);
    }
    return std::nullopt;
}

}  // namespace

std::optional<std::string> find_unsoundness(const Foam& foam, double tolerance) {
    if (const auto fault = find_fault(foam.network)) {
        return fmt::format("invalid network: {}", *fault);
    }
    if (!all_finite(foam)) {
        return "a number that is not finite";
    }
    if (auto fault = find_target_fault(foam)) {
        return fault;
    }
    if (auto error = find_error(foam, tolerance)) {
        return error;
    }
    return foam.domain.is_plane() ? find_work_error(foam, tolerance) : std::nullopt;
}

const char* name_of(EquilibriumStatus status) {
    switch (status) {
        case EquilibriumStatus::Converged:
            return "converged";
        case EquilibriumStatus::RoundLimit:
            return "round limit";
        case EquilibriumStatus::ToleranceMissed:
            return "tolerance missed";
    }
    return "unknown status";
}

}  // namespace foam::stress
