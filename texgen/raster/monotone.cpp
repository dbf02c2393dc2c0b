#include "texgen/raster/monotone.h"

#include <cmath>
#include <numbers>

namespace foam::texgen {

namespace {

constexpr double kQuarter = 0.5 * std::numbers::pi;

// Whether an arc of less than half a turn goes back neither in x nor in y: all its tangents lie
// between those at its ends.
bool is_monotone(const PixelArc& arc) {
    const Vec2 along = arc.cosine * arc.chord;
    const Vec2 across = arc.sine * turned_left(arc.chord);
    const Vec2 first = along - across;
    const Vec2 last = along + across;
    return arc.cosine > 0.0 && first.x() * last.x() >= 0.0 && first.y() * last.y() >= 0.0;
}

}  // namespace

MonotonePieces::MonotonePieces(const PixelArc& arc) {
    if (is_monotone(arc)) {
        append(arc.chord, arc.sine);
    } else {
        split(arc);
    }
}

// Where the tangent is parallel to an axis. The chord from the tail to where it has turned by an
// angle t is, with r the radius, 2 r sin(t / 2) long and turned by t / 2 from the tangent there.
void MonotonePieces::split(const PixelArc& arc) {
    const double half_angle = std::atan2(arc.sine, arc.cosine);
    const double direction = std::atan2(arc.chord.y(), arc.chord.x());
    const double first = direction - half_angle;
    const double last = direction + half_angle;
    const double sign = half_angle < 0.0 ? -1.0 : 1.0;
    const double diameter = arc.chord.norm() / std::abs(arc.sine);
    double from = first;
    double quarter = sign * (std::floor(sign * first / kQuarter) + 1.0);
    for (; sign * (quarter * kQuarter - last) < 0.0; quarter += sign) {
        const double to = quarter * kQuarter;
        const double turn = to - first;
        const double length = diameter * std::sin(0.5 * std::abs(turn));
        const double angle = first + 0.5 * turn;
        append(length * Vec2(std::cos(angle), std::sin(angle)), std::sin(0.5 * (to - from)));
        from = to;
    }
    append(arc.chord, std::sin(0.5 * (last - from)));
}

}  // namespace foam::texgen
