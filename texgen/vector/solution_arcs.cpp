// SPDX-License-Identifier: Apache-2.0

#include "texgen/vector/solution_arcs.h"

#include "core/geometry/elementary.h"

#include <cmath>
#include <cstddef>

namespace foam::texgen {

namespace {

double angle_between(const Vec2& a, const Vec2& b) {
    return ieee::atan2(cross(a, b), a.dot(b));
}

// Returns the length d of the two handles of a biarc. The biarc consists of two arcs. It begins at
// a with the direction t, and ends at b = a + chord with the direction u. The arcs meet halfway
// between the ends of the handles, a + d t and b - d u. Therefore d is the positive root of
// chord² = 2 d chord · (t + u) + 2 d² (1 - t · u).
double handle_of(const Vec2& chord, const Vec2& t, const Vec2& u) {
    const double quadratic = 2.0 * (1.0 - t.dot(u));
    const double half_linear = chord.dot(t + u);
    return chord.squaredNorm() /
           (half_linear + std::sqrt(half_linear * half_linear + quadratic * chord.squaredNorm()));
}

}  // namespace

std::vector<DrawnArc> smooth_arcs(const std::vector<Station>& stations, const Page& page) {
    std::vector<DrawnArc> arcs;
    for (std::size_t k = 1; k < stations.size(); ++k) {
        const Station& from = stations[k - 1];
        const Station& to = stations[k];
        const Vec2 a = page(from.position);
        const Vec2 b = page(to.position);
        const double handle = handle_of(b - a, from.direction, to.direction);
        const Vec2 middle = 0.5 * (a + b + handle * (from.direction - to.direction));
        arcs.push_back({a, middle, angle_between(from.direction, middle - a)});
        arcs.push_back({middle, b, angle_between(b - middle, to.direction)});
    }
    return arcs;
}

}  // namespace foam::texgen
