// SPDX-License-Identifier: Apache-2.0

#include "texgen/cache/frame_check.h"

#include "core/files/input_limits.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <unordered_set>

namespace foam::texgen {

namespace {

// The largest plausible absolute value of a number in a frame, in foam units. The mean area of the
// seeded foam is 1, and the seeded foam has at most 1e6 bubbles, so that all numbers are far below
// this limit.
constexpr double kMaxPlausibleNumber = 1e15;

using Fault = std::optional<std::string>;

bool is_positive(double number) {
    return is_plausible(number) && number > 0.0;
}

bool is_plausible_point(const Vec2& point) {
    return is_plausible(point.x()) && is_plausible(point.y());
}

Fault fault_of_domain(const Frame& frame) {
    const Domain& domain = frame.domain;
    const bool has_ghost = frame.network.ghost() != kNone<BubbleId>;
    if (has_ghost) {
        const bool is_plane = domain.width == 0.0 && domain.height == 0.0 && domain.shear == 0.0;
        return is_plane ? std::nullopt : Fault("a foam with a free surface must be in the plane");
    }
    if (!is_positive(domain.width) || !is_positive(domain.height) || !has_moderate_shape(domain)) {
        return fmt::format(
            "the torus has an impossible size, {} x {}", domain.width, domain.height);
    }
    if (!(std::abs(domain.shear) <= domain.width)) {
        return fmt::format(
            "the shear of the torus, {}, is larger than its width, {}", domain.shear, domain.width);
    }
    return std::nullopt;
}

bool is_near_torus(const Vec2& point, const Domain& torus) {
    return std::abs(point.x()) <= 2.0 * torus.width && std::abs(point.y()) <= 2.0 * torus.height;
}

Fault fault_of_positions(const Frame& frame) {
    for (const JunctionId junction : frame.network.junctions()) {
        const Vec2& position = frame.positions[junction];
        if (!is_plausible_point(position) ||
            (!frame.domain.is_plane() && !is_near_torus(position, frame.domain))) {
            return fmt::format("junction {} has an impossible position, ({}, {})",
                               index_of(junction),
                               position.x(),
                               position.y());
        }
    }
    return std::nullopt;
}

Fault fault_of_films(const Frame& frame) {
    const double longest =
        frame.domain.is_plane() ? kMaxPlausibleNumber : frame.domain.width + frame.domain.height;
    for (const FilmId film : frame.network.films()) {
        const FilmArc& arc = frame.arcs[film];
        if (!(std::abs(arc.half_angle) < std::numbers::pi) || !(arc_length(arc) <= longest)) {
            return fmt::format(
                "film {} has an impossible shape: a chord ({}, {}) and a half angle "
                "of {} radians",
                index_of(film),
                arc.chord.x(),
                arc.chord.y(),
                arc.half_angle);
        }
    }
    return std::nullopt;
}

// Checks a bubble, and adds its identity to `identities`.
Fault fault_of_bubble(BubbleIdentity identity,
                      double target_area,
                      std::unordered_set<BubbleIdentity>& identities) {
    if (identity >= kMaxIdentity) {
        return fmt::format("the identity {} of a bubble must be below {}", identity, kMaxIdentity);
    }
    if (!identities.insert(identity).second) {
        return fmt::format("two bubbles have the identity {}", identity);
    }
    if (!is_positive(target_area)) {
        return fmt::format("bubble {} has an impossible target area, {}", identity, target_area);
    }
    return std::nullopt;
}

Fault fault_of_bubbles(const Frame& frame) {
    std::unordered_set<BubbleIdentity> identities;
    for (const FrameBubble& bubble : frame.bubbles) {
        if (Fault fault = fault_of_bubble(bubble.identity, bubble.target_area, identities)) {
            return fault;
        }
        if (!is_plausible(bubble.pressure) || !is_plausible(bubble.area)) {
            return fmt::format("bubble {} has an impossible pressure, {}, or area, {}",
                               bubble.identity,
                               bubble.pressure,
                               bubble.area);
        }
    }
    if (!std::ranges::is_sorted(frame.lone_bubbles, {}, &LoneBubble::identity)) {
        return "the bubbles without neighbors are not in the order of their identities";
    }
    for (const LoneBubble& bubble : frame.lone_bubbles) {
        if (Fault fault = fault_of_bubble(bubble.identity, bubble.target_area, identities)) {
            return fault;
        }
        if (!is_plausible_point(bubble.center)) {
            return fmt::format("bubble {} has an impossible position, ({}, {})",
                               bubble.identity,
                               bubble.center.x(),
                               bubble.center.y());
        }
    }
    return std::nullopt;
}

}  // namespace

bool is_plausible(double number) {
    return std::abs(number) <= kMaxPlausibleNumber;
}

std::optional<std::string> find_frame_fault(const Frame& frame) {
    if (!is_plausible(frame.time) || !is_positive(frame.film_tension)) {
        return fmt::format("the foam has an impossible time, {}, or film tension, {}",
                           frame.time,
                           frame.film_tension);
    }
    for (const auto& fault_of :
         {fault_of_domain, fault_of_positions, fault_of_films, fault_of_bubbles}) {
        if (Fault fault = fault_of(frame)) {
            return fault;
        }
    }
    return std::nullopt;
}

}  // namespace foam::texgen
