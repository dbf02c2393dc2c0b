#include "texgen/raster/side_arc.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace foam::texgen {

namespace {

// Signed distance to the left of the arc's whole circle; 1 - 2 curvature f is the squared distance
// from the centre over the squared radius.
double distance_left(const SideArc& arc, const Vec2& point) {
    const Vec2 y = point - arc.middle;
    const double f = turned_left(arc.direction).dot(y) - 0.5 * arc.curvature * y.squaredNorm();
    return 2.0 * f / (1.0 + std::sqrt(std::max(0.0, 1.0 - 2.0 * arc.curvature * f)));
}

// Whether the nearest point of the whole circle lies on the arc: within the wedge of its end
// normals.
bool faces(const SideArc& arc, const Vec2& point) {
    const bool past_tail = arc.tail_tangent.dot(point - arc.tail) >= 0.0;
    const bool before_head = arc.head_tangent.dot(point - arc.head) <= 0.0;
    const bool convex_wedge = arc.cosine >= 0.0;
    return convex_wedge ? past_tail && before_head : past_tail || before_head;
}

}  // namespace

SideArc place(const PixelArc& arc, const Vec2& tail) {
    const double length = arc.chord.norm();
    const double c = arc.cosine;
    const double s = arc.sine;
    SideArc side;
    side.direction = arc.chord / length;
    const Vec2 left = turned_left(side.direction);
    side.tail = tail;
    side.head = tail + arc.chord;
    side.tail_tangent = c * side.direction - s * left;
    side.head_tangent = c * side.direction + s * left;
    side.curvature = 2.0 * s / length;
    side.cosine = c;
    side.reach = length / (1.0 + c);
    side.middle = tail + 0.5 * (arc.chord - side.reach * s * left);
    side.extent = (side.head - side.middle).norm();
    return side;
}

std::optional<SideArc> offset_left(const SideArc& arc, double distance) {
    const double shrinkage = 1.0 - arc.curvature * distance;
    if (shrinkage < kSmallestShrinkage) {
        return std::nullopt;
    }
    SideArc offset = arc;
    offset.tail += distance * turned_left(arc.tail_tangent);
    offset.head += distance * turned_left(arc.head_tangent);
    offset.middle += distance * turned_left(arc.direction);
    offset.curvature = arc.curvature / shrinkage;
    offset.reach = arc.reach * shrinkage;
    offset.extent = arc.extent * shrinkage;
    return offset;
}

SideArc corner_arc(const SideArc& before, const SideArc& after, double distance) {
    const Vec2& from = before.head_tangent;
    const Vec2& to = after.tail_tangent;
    const Vec2 bisector = from + to;
    SideArc cap;
    cap.tail = before.head + distance * turned_left(from);
    cap.head = before.head + distance * turned_left(to);
    cap.tail_tangent = from;
    cap.head_tangent = to;
    cap.direction = bisector.norm() > 0.0 ? Vec2(bisector.normalized()) : Vec2(-turned_left(from));
    cap.middle = before.head + distance * turned_left(cap.direction);
    cap.curvature = -1.0 / distance;
    cap.cosine = 0.5 * bisector.norm();
    cap.reach = distance * (to - from).norm() / (1.0 + cap.cosine);
    cap.extent = (cap.head - cap.middle).norm();
    return cap;
}

Crossings crossings(const SideArc& arc, const SideArc& other) {
    const auto circle_of = [](const SideArc& of) {
        const auto& [x, y] = std::pair(of.middle.x(), of.middle.y());
        return ArcCircle{x, y, of.direction.x(), of.direction.y(), of.curvature};
    };
    return crossings(circle_of(arc), circle_of(other));
}

Vec2 point_at(const SideArc& arc, double parameter) {
    const double tangent = 0.5 * arc.curvature * parameter;
    const double scale = parameter / (1.0 + tangent * tangent);
    return arc.middle + scale * (arc.direction + tangent * turned_left(arc.direction));
}

// The parameters are tangents of half the angle turned since the middle, of which half angles are
// differences.
PixelArc piece(const SideArc& arc, double from, double to) {
    const double half = 0.5 * arc.curvature;
    const double sine = half * (to - from);
    const double cosine = 1.0 + half * half * from * to;
    const double over = 1.0 / std::sqrt(sine * sine + cosine * cosine);
    return {point_at(arc, to) - point_at(arc, from), cosine * over, sine * over};
}

double distance(const SideArc& arc, const Vec2& point) {
    if (faces(arc, point)) {
        return std::abs(distance_left(arc, point));
    }
    return std::sqrt(std::min((point - arc.tail).squaredNorm(), (point - arc.head).squaredNorm()));
}

}  // namespace foam::texgen
