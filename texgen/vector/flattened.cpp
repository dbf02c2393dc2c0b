// SPDX-License-Identifier: Apache-2.0

#include "texgen/vector/flattened.h"

#include "core/geometry/elementary.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace foam::texgen {

std::size_t part_count(const DrawnArc& arc, double tolerance) {
    const double length = (arc.head - arc.tail).norm();
    const double half_angle = std::abs(arc.half_angle);
    const double sine = ieee::sin(half_angle);
    if (length == 0.0 || sine <= 0.0) {
        return 1;
    }
    // An arc of radius r and half angle a is at most r (1 - cos a) <= r a² / 2 away from its chord.
    // For each part, this distance must not exceed the tolerance, and a must not exceed
    // kMaxPartHalfAngle.
    constexpr double kMaxPartHalfAngle = 0.25;
    const double radius = 0.5 * length / sine;
    const double part = std::min(kMaxPartHalfAngle, std::sqrt(2.0 * tolerance / radius));
    return static_cast<std::size_t>(std::max(1.0, std::ceil(half_angle / part)));
}

std::vector<Ring> flattened(std::span<const Chain> chains, double tolerance) {
    std::vector<Ring> rings;
    for (const Chain& chain : chains) {
        Ring ring;
        for (const DrawnArc& arc : arcs_of(chain)) {
            const std::size_t parts = part_count(arc, tolerance);
            ring.push_back(arc.tail);
            for (std::size_t k = 1; k < parts; ++k) {
                const double fraction = static_cast<double>(k) / static_cast<double>(parts);
                ring.push_back(arc.tail + point_at(arc.arc(), fraction));
            }
        }
        rings.push_back(std::move(ring));
    }
    return rings;
}

}  // namespace foam::texgen
