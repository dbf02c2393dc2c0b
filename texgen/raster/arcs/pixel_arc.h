// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/geometry/elementary.h"
#include "core/geometry/film_arc.h"

#include <boost/container/static_vector.hpp>

#include <cstddef>
#include <span>
#include <vector>

namespace foam::texgen {

/// A circular arc from its tail to its head. The unit of length is the pixel, unless stated
/// otherwise. Unlike a FilmArc, a PixelArc stores the cosine and the sine of the half angle, not
/// the half angle itself.
struct PixelArc {
    Vec2 chord{0.0, 0.0};  // head minus tail
    double cosine = 1.0;   // cosine of half the angle by which the arc turns left
    double sine = 0.0;     // sine of the same half angle
};

/// Convert an arc to the other type, without a change of the unit of length.
inline PixelArc pixel_arc(const FilmArc& arc) {
    const auto [sine, cosine] = ieee::sincos(arc.half_angle);
    return {arc.chord, cosine, sine};
}
inline FilmArc film_arc(const PixelArc& arc) {
    return {arc.chord, ieee::atan2(arc.sine, arc.cosine)};
}

/// Returns the same arc in the direction from head to tail.
inline PixelArc reversed(const PixelArc& arc) {
    return {-arc.chord, arc.cosine, -arc.sine};
}

/// Return the tangent vectors at the ends of an arc, in the direction from tail to head. Their
/// length is the length of the chord.
inline Vec2 tail_tangent(const PixelArc& arc) {
    return arc.cosine * arc.chord - arc.sine * turned_left(arc.chord);
}
inline Vec2 head_tangent(const PixelArc& arc) {
    return arc.cosine * arc.chord + arc.sine * turned_left(arc.chord);
}

/// Returns true if a boundary turns right at the corner between two successive sides.
template <class Arc>
bool turns_right(const Arc& before, const Arc& after) {
    return cross(head_tangent(before), tail_tangent(after)) < 0.0;
}

/// Returns true if an arc is monotone in x and in y: neither coordinate reverses its direction
/// along the arc. This is the case if the arc turns by less than 180 degrees, and the tangents at
/// its ends are in the same quadrant, where a quadrant includes both of its axes. A monotone arc
/// therefore turns by at most 90 degrees.
inline bool is_monotone(const PixelArc& arc) {
    const Vec2 first = tail_tangent(arc);
    const Vec2 last = head_tangent(arc);
    return arc.cosine > 0.0 && first.x() * last.x() >= 0.0 && first.y() * last.y() >= 0.0;
}

/// A piece of an arc that is monotone in x and in y (is_monotone).
struct MonotonePiece {
    Vec2 tail{0.0, 0.0};
    Vec2 head{0.0, 0.0};
    double sine = 0.0;  // sine of half the angle by which the piece turns left; the half angle is
                        // from -45 to 45 degrees
};

/// Splits an arc that turns by less than 360 degrees into monotone pieces, in order from tail to
/// head. Positions are relative to the tail of the arc.
boost::container::static_vector<MonotonePiece, 5> monotone_pieces(const PixelArc& arc);

/// Calls visit(from, to, sine) for each monotone piece of an arc, in order. `from` and `to` are the
/// ends of the piece, and `sine` is as in MonotonePiece. `tail` and `head` are the ends of the arc,
/// as points of any type. inner(position) converts a point between two pieces to this type.
/// `position` is relative to the tail, in the unit of the arc.
template <class Point, class Inner, class Visit>
void for_each_piece(const PixelArc& arc,
                    const Point& tail,
                    const Point& head,
                    const Inner& inner,
                    const Visit& visit) {
    if (is_monotone(arc)) [[likely]] {
        visit(tail, head, arc.sine);
        return;
    }
    const auto pieces = monotone_pieces(arc);
    Point from = tail;
    for (const MonotonePiece& piece : pieces) {
        const Point to = &piece == &pieces.back() ? head : inner(piece.head);
        visit(from, to, piece.sine);
        from = to;
    }
}

/// Returns twice the area between an arc and its chord, with the sign of `sine`, the sine of half
/// the angle by which the arc turns left. The formula is a truncated power series of the segment
/// area in E1 (core/EQUATIONS.md). Its relative error is 2.5e-3 for an arc that turns by 90
/// degrees, 6e-5 for 60 degrees and 6e-9 for 23 degrees. Precondition: the arc turns by at most 90
/// degrees.
template <class Real>
Real twice_segment(Real squared_chord, Real sine) {
    const Real z = sine * sine;
    const Real series =
        1 + z * (Real(3) / 10 + z * (Real(9) / 56 + z * (Real(5) / 48 + z * (Real(105) / 1408))));
    return squared_chord * sine * (Real(1) / 3) * series;
}

/// Closed loops of arcs in pixels. The region that the loops bound is on their left.
struct ArcLoops {
    struct Side {
        Vec2 tail{0.0, 0.0};
        PixelArc arc;  // ends at the tail of the next side of the loop
    };
    std::vector<Side> sides;
    std::vector<std::size_t> loop_ends;  // one past the last side of each loop
    // The number of loops left out because they did not close. It is 0 for a valid bubble, but may
    // be positive for the ghost bubble of a patch in which rafts overlap each other or themselves.
    int unclosed_loops = 0;

    /// Removes all loops, and keeps the memory.
    void clear() {
        sides.clear();
        loop_ends.clear();
        unclosed_loops = 0;
    }
    /// Returns the sides of loop k.
    std::span<const Side> loop(std::size_t k) const {
        const std::size_t begin = k == 0 ? 0 : loop_ends[k - 1];
        return std::span(sides).subspan(begin, loop_ends[k] - begin);
    }
};

}  // namespace foam::texgen
