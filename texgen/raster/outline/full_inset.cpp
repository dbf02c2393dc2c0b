// SPDX-License-Identifier: Apache-2.0

#include "texgen/raster/outline/full_inset.h"

#include "texgen/raster/coords/raster_grid.h"

#include <algorithm>
#include <cmath>

// This is a fast path for bubbles whose inset has the form that the header describes. It joins the
// offsets of adjacent sides at their crossings, which takes one cut per corner. In general, offsets
// that are joined in this way can cross each other again (W. Tiller and E. G. Hanson, "Offsets of
// two-dimensional profiles", 1984). The code therefore proves for every pair of a piece and a side
// that the piece is far enough from the side. If a bound fails, the code gives up, and InsetTracer
// finds the inset. The bounds and the proof are our own; one bound uses the intersecting chords
// theorem (Euclid, "Elements", III.35).

namespace foam::texgen {

namespace {

// Limits on two angles. The half angle of a side must be at most 60 degrees. The left turn from one
// side to the next must be from 0.06 to 120 degrees. Suppose that the offsets of two successive
// sides cross exactly once. A point of one offset beyond this crossing is too near to the circle of
// the other side. Within the limits, the nearest point of this circle is on that side. The point of
// the offset is therefore too near to the side, too.
constexpr double kMinSideCosine = 0.5;
constexpr double kMinCornerSine = 1e-3;
constexpr double kMinCornerCosine = -0.5;

bool turns_clearly_left(const OffsetArc& before, const OffsetArc& after) {
    const Vec2 from = head_tangent(before);
    const Vec2 to = tail_tangent(after);
    return cross(from, to) > kMinCornerSine && from.dot(to) > kMinCornerCosine;
}

}  // namespace

// Stores the sides and their offsets. Returns false if a side is too short, turns by too wide an
// angle, or has no offset.
bool FullInset::offset_sides(std::span<const ArcLoops::Side> loop, double distance) {
    sides_.clear();
    for (const ArcLoops::Side& side : loop) {
        const OffsetArc arc = offset_arc_from(side.arc, side.tail);
        if (!(side.arc.chord.norm() > kShortestChord) || !(arc.cosine >= kMinSideCosine) ||
            !(shrinkage(arc, distance) >= kMinShrinkage)) {
            return false;
        }
        sides_.push_back({arc, offset_left(arc, distance)});
    }
    return true;
}

// Cuts the offsets of successive sides at their crossing. Beyond the crossing, each offset is too
// near to the side of the other offset. Returns false in these cases:
// - A piece between two cuts is too short.
// - Two successive offsets do not cross exactly once.
// - The turn between two sides is not within the limits.
bool FullInset::cut_corners() {
    for (std::size_t k = 0; k < sides_.size(); ++k) {
        Side& before = sides_[k];
        Side& after = side(k + 1);
        const Crossings ahead = crossings(before.offset, after.offset);
        const Crossings back = crossings(after.offset, before.offset);
        before.to = ahead.leaving;
        after.from = back.entering;
        const bool is_on_both =
            std::abs(before.to) < before.offset.reach && std::abs(after.from) < after.offset.reach;
        const bool crosses_twice =
            (ahead.entering > ahead.leaving && ahead.entering <= before.offset.reach) ||
            (back.leaving < back.entering && back.leaving >= -after.offset.reach);
        if (!is_on_both || crosses_twice || !turns_clearly_left(before.arc, after.arc)) {
            return false;
        }
    }
    for (Side& side : sides_) {
        side.tail = point_at(side.offset, side.from);
    }
    return std::all_of(sides_.begin(), sides_.end(), [](const Side& side) {
        return side.to - side.from > kShortestPiece;
    });
}

const ArcLoops* FullInset::trace(std::span<const ArcLoops::Side> loop, double distance) {
    constexpr std::size_t kFewestSides = 3;
    if (loop.size() < kFewestSides || !offset_sides(loop, distance) || !cut_corners()) {
        return nullptr;
    }
    inset_.clear();
    for (std::size_t k = 0; k < sides_.size(); ++k) {
        if (!keeps_clear_of(k, distance)) {
            return nullptr;
        }
        const Side& own = sides_[k];
        const HalfAngle turn = half_angle_between(own.offset.curvature, own.from, own.to);
        inset_.sides.push_back({own.tail, {side(k + 1).tail - own.tail, turn.cosine, turn.sine}});
    }
    inset_.loop_ends.push_back(sides_.size());
    return &inset_;
}

// Returns true only if the pieces of all other sides have at least the given distance from side k.
// These pieces are then on the left of the offset of side k.
//
// Let p and q be the signed distances of the two ends of a piece from the offset of side k,
// positive on the left of the offset. Let c be the length of the chord of the piece, and a and b
// the absolute curvatures of the piece and of the side. Let t be a fraction of the chord, counted
// from the end with the distance q. The signed distance of the piece from the offset at this
// fraction is at least
//     t p + (1 - t) q - t (1 - t) c² (a + b).
// The term with a bounds the distance of the piece from its chord (intersecting chords theorem).
// The term with b bounds the difference between the signed distance of the chord and its linear
// interpolation. The signed distance of the piece is not negative for any t if
//     c² (a + b) <= (sqrt p + sqrt q)².
// The code compares c² (a + b) with p + q + 2 min(p, q), which is at most the right-hand side.
//
// The piece of an adjacent side has one end on the offset of side k. It does not cross this offset
// again if its other end is on the left of the offset.
bool FullInset::keeps_clear_of(std::size_t k, double distance) {
    const OffsetArc& arc = sides_[k].arc;
    double p = 0.0;
    for (std::size_t ahead = 2; ahead < sides_.size(); ++ahead) {
        const Vec2& point = side(k + ahead).tail;
        const double q = distance_left(arc, point) - distance;
        if (q < 0.0) {
            return false;
        }
        if (ahead > 2) {
            const Side& piece = side(k + ahead - 1);
            const double bend = (point - piece.tail).squaredNorm() *
                                (std::abs(piece.offset.curvature) + std::abs(arc.curvature));
            if (bend > p + q + 2.0 * std::min(p, q)) {
                return false;
            }
        }
        p = q;
    }
    return true;
}

}  // namespace foam::texgen
