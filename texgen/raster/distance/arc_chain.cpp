#include "texgen/raster/distance/arc_chain.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace foam::texgen {

namespace {

// In pixels. Points outside the arc make up for the area that edges cut off where a pixel holds an
// edge or more. A longer edge stands alone, and the ends of a short arc cannot move out, so that an
// arc gets one edge more than the sagitta asks for.
constexpr double kSagittaOfShortEdges = 1.0 / 256;
constexpr double kShortEdge = std::numbers::sqrt2;
constexpr double kSagitta = 1.0 / 1024;

struct Rotation {
    double c;
    double s;

    Rotation(double cosine, double sine) : c(cosine), s(sine) {}
    explicit Rotation(double angle) : Rotation(std::cos(angle), std::sin(angle)) {}

    Rotation twice() const { return {c * c - s * s, 2.0 * c * s}; }
    Vec2 operator*(const Vec2& v) const { return {c * v.x() - s * v.y(), s * v.x() + c * v.y()}; }
    Vec2 back(const Vec2& v) const { return {c * v.x() + s * v.y(), c * v.y() - s * v.x()}; }
};

// An arc of length l and half angle a has a sagitta of at most l a / 4; so has each of n equal
// parts, with l / n and a / n.
int edge_count(const FilmArc& arc, double sine) {
    const double turn = std::abs(arc.half_angle);
    const double length = arc.chord.norm() * turn / std::abs(sine);  // NaN on a straight arc
    const double sagitta = 0.25 * length * turn;
    if (!(sagitta > kSagitta)) {
        return 1;
    }
    const double coarse = std::max(std::sqrt(sagitta / kSagittaOfShortEdges), length / kShortEdge);
    return 1 + static_cast<int>(std::ceil(std::min(coarse, std::sqrt(sagitta / kSagitta))));
}

}  // namespace

// The n edges cut off n segments of 2/3 sagitta x edge; each of the n - 1 inner points gains its
// distance from the arc times one edge. Two edges add up to 2 cos(half_step) edges along the
// tangent between them.
void append_inner_points(const FilmArc& arc, const Vec2& tail, std::vector<Vec2>& points) {
    const Rotation half_turn(arc.half_angle);
    const int edges = edge_count(arc, half_turn.s);
    if (edges == 1) {
        return;
    }
    const Rotation half_step(arc.half_angle / edges);
    const Rotation step = half_step.twice();
    Vec2 edge = half_step * half_turn.back(arc.chord) * (half_step.s / half_turn.s);
    const double sagitta = 0.5 * half_step.s / (1.0 + half_step.c);  // over the length of an edge
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
