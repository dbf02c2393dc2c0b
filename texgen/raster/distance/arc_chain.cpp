// SPDX-License-Identifier: Apache-2.0

#include "texgen/raster/distance/arc_chain.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace foam::texgen {

namespace {

// The inner points are moved outwards, away from the center of the circle, to compensate for the
// area that the edges cut off. Within a pixel that contains whole edges, the area that is cut off
// and the area that is added cancel, so short edges may have a larger sagitta (the largest distance
// of an arc from its chord). Longer edges must be accurate on their own. The ends of the arc cannot
// be moved outwards. n edges have only n - 1 inner points that can compensate, and a single edge
// has no inner point. An arc whose sagitta is above kSagitta therefore gets one edge more than the
// limits below require. A flatter arc is replaced by its chord. All lengths are in pixels.
constexpr double kSagittaOfShortEdges = 1.0 / 256;  // largest sagitta of short edges
constexpr double kShortEdge = std::numbers::sqrt2;  // largest length of short edges
constexpr double kSagitta = 1.0 / 1024;             // largest sagitta of longer edges

// A rotation to the left by an angle, stored as its cosine and sine.
struct Rotation {
    double c;
    double s;

    Rotation(double cosine, double sine) : c(cosine), s(sine) {}
    explicit Rotation(double angle) : Rotation(std::cos(angle), std::sin(angle)) {}

    // Returns the rotation by twice the angle.
    Rotation twice() const { return {c * c - s * s, 2.0 * c * s}; }
    Vec2 operator*(const Vec2& v) const { return {c * v.x() - s * v.y(), s * v.x() + c * v.y()}; }
    // Returns v rotated in the opposite direction.
    Vec2 back(const Vec2& v) const { return {c * v.x() + s * v.y(), c * v.y() - s * v.x()}; }
};

// Returns the number of edges of a chain. `sine` is the sine of the half angle. An arc of length l
// and half angle a has a sagitta of at most l a / 4. Each of n equal parts has the length l / n and
// the half angle a / n, so that the sagitta of a part is smaller by a factor of n².
int edge_count(const FilmArc& arc, double sine) {
    const double turn = std::abs(arc.half_angle);
    const double length = arc.chord.norm() * turn / std::abs(sine);  // NaN for a straight arc
    const double sagitta = 0.25 * length * turn;
    if (!(sagitta > kSagitta)) {  // true for NaN, too
        return 1;
    }
    const double coarse = std::max(std::sqrt(sagitta / kSagittaOfShortEdges), length / kShortEdge);
    return 1 + static_cast<int>(std::ceil(std::min(coarse, std::sqrt(sagitta / kSagitta))));
}

}  // namespace

// The n edges, each of length e, cut off n circular segments, each with an area of about
// 2/3 sagitta * e. Moving an inner point outwards by a distance adds an area of about distance * e,
// and there are n - 1 inner points. The total areas that are cut off and
// added are equal for distance = 2/3 sagitta * n / (n - 1). The outward direction is normal to the
// sum of the two edge vectors at the point. The length of this sum is 2 cos(half_step) times the
// length of an edge.
void append_chain_points(const FilmArc& arc, const Vec2& tail, std::vector<Vec2>& points) {
    const Rotation half_turn(arc.half_angle);
    const int edges = edge_count(arc, half_turn.s);
    if (edges == 1) {
        return;
    }
    const Rotation half_step(arc.half_angle / edges);
    const Rotation step = half_step.twice();
    Vec2 edge = half_step * half_turn.back(arc.chord) * (half_step.s / half_turn.s);
    // In units of the length of an edge; negative if the arc turns right.
    const double sagitta = 0.5 * half_step.s / (1.0 + half_step.c);
    const double outwards = 2.0 / 3.0 * sagitta * edges / (edges - 1) / (2.0 * half_step.c);
    Vec2 at = tail;
    for (int k = 1; k < edges; ++k) {
        const Vec2 next_edge = step * edge;
        at += edge;
        points.emplace_back(at - outwards * turned_left(edge + next_edge));
        edge = next_edge;
    }
}

}  // namespace foam::texgen
