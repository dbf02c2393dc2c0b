// SPDX-License-Identifier: Apache-2.0

#include "texgen/raster/arcs/pixel_arc.h"

#include <array>
#include <cmath>
#include <utility>

namespace foam::texgen {

namespace {

// Returns the quadrant of a direction: 0 to 3, counter-clockwise from the x axis. Each quadrant
// includes the axis at which it begins, but not the axis at which it ends.
int quadrant_of(const Vec2& direction) {
    const auto [x, y] = std::pair(direction.x(), direction.y());
    if (y > 0.0) {
        return x > 0.0 ? 0 : 1;
    }
    if (y < 0.0) {
        return x < 0.0 ? 2 : 3;
    }
    return x > 0.0 ? 0 : 2;
}

// Returns the direction of the axis at which a quadrant begins. `quadrant` is taken modulo 4.
Vec2 axis(int quadrant) {
    constexpr std::array<double, 5> kCosines{1.0, 0.0, -1.0, 0.0, 1.0};
    const auto k = static_cast<std::size_t>(quadrant % 4);
    return {kCosines[k], -kCosines[k + 1]};
}

}  // namespace

// Splits the arc where its tangent is parallel to an axis. An arc that turns right is mirrored in y
// first; the results are then mirrored back. Let a and b be the unit tangents at two points of an
// arc that turns left. The vector from the first point to the second is radius * (b - a), rotated
// by 90 degrees to the right. The sine of half the angle between a and b is |b - a| / 2.
boost::container::static_vector<MonotonePiece, 5> monotone_pieces(const PixelArc& arc) {
    if (is_monotone(arc)) {
        return {MonotonePiece{Vec2::Zero(), arc.chord, arc.sine}};
    }
    boost::container::static_vector<MonotonePiece, 5> pieces;
    const auto append = [&](const Vec2& head, double sine) {
        pieces.push_back({pieces.empty() ? Vec2(0.0, 0.0) : pieces.back().head, head, sine});
    };
    const double side = arc.sine < 0.0 ? -1.0 : 1.0;
    const Vec2 mirror(1.0, side);
    const double length = arc.chord.norm();
    const double radius = 0.5 * length / std::abs(arc.sine);
    const Vec2 along = mirror.cwiseProduct(arc.chord) * (arc.cosine / length);
    const Vec2 across = turned_left(mirror.cwiseProduct(arc.chord)) * (std::abs(arc.sine) / length);
    const Vec2 first = along - across;
    const Vec2 last = along + across;
    const int begin = quadrant_of(first);
    int end = quadrant_of(last);
    if (end < begin || (end == begin && arc.cosine < 0.0)) {
        end += 4;
    }
    Vec2 from = first;
    for (int quadrant = begin + 1; quadrant <= end; ++quadrant) {
        const Vec2 to = axis(quadrant);
        const Vec2 head = -radius * turned_left(to - first);
        append(mirror.cwiseProduct(head), 0.5 * side * (to - from).norm());
        from = to;
    }
    append(arc.chord, 0.5 * side * (last - from).norm());
    return pieces;
}

}  // namespace foam::texgen
