// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/raster/arcs/pixel_arc.h"

#include <vector>

namespace foam::texgen {

/// Appends a loop whose sides are arcs of one half angle between the corners of a polygon.
inline void add_polygon(const std::vector<Vec2>& corners, double half_angle, ArcLoops& to) {
    for (std::size_t k = 0; k < corners.size(); ++k) {
        const Vec2 chord = corners[(k + 1) % corners.size()] - corners[k];
        to.sides.push_back({corners[k], pixel_arc({chord, half_angle})});
    }
    to.loop_ends.push_back(to.sides.size());
}

/// Returns a single loop of this kind.
inline ArcLoops polygon(const std::vector<Vec2>& corners, double half_angle = 0.0) {
    ArcLoops loops;
    add_polygon(corners, half_angle, loops);
    return loops;
}

}  // namespace foam::texgen
