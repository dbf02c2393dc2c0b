#include "texgen/raster/plain_inset.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace foam::texgen {

namespace {

constexpr double kLeastSideCosine = 0.5;  // of half the angle that a side turns
// What two sides turn by where they meet, at least and at most: then the nearest points of both
// lie on the sides themselves.
constexpr double kLeastSine = 1e-3;
constexpr double kLeastCosine = -0.5;

bool meets_plainly(const SideArc& before, const SideArc& after) {
    return cross(before.head_tangent, after.tail_tangent) > kLeastSine &&
           before.head_tangent.dot(after.tail_tangent) > kLeastCosine;
}

// No more than the signed distance to the left of the arc's whole circle.
double least_distance_left(const SideArc& arc, const Vec2& point) {
    const Vec2 y = point - arc.middle;
    const double f = turned_left(arc.direction).dot(y) - 0.5 * arc.curvature * y.squaredNorm();
    return arc.curvature >= 0.0 || f <= 0.0 ? f : f / (1.0 - 0.5 * arc.curvature * f);
}

}  // namespace

bool PlainInset::trace(std::span<const SideArc> sides, double distance, ArcLoops& loops) {
    if (sides.size() < 3 || sides.size() > kMostSides || !find_offsets(sides, distance) ||
        !find_crossings() || !keeps_distance(sides, distance)) {
        return false;
    }
    for (std::size_t k = 0; k < count_; ++k) {
        const Offset& offset = offsets_[k];
        PixelArc arc = piece(offset.arc, offset.from, offset.to);
        arc.chord = offsets_[k + 1 < count_ ? k + 1 : 0].tail - offset.tail;
        loops.arcs.push_back({offset.tail, arc});
    }
    loops.loop_ends.push_back(loops.arcs.size());
    return true;
}

bool PlainInset::find_offsets(std::span<const SideArc> sides, double distance) {
    count_ = sides.size();
    for (std::size_t k = 0; k < count_; ++k) {
        const SideArc& next = sides[k + 1 < count_ ? k + 1 : 0];
        const std::optional<SideArc> offset = offset_left(sides[k], distance);
        if (!offset || sides[k].cosine < kLeastSideCosine || !meets_plainly(sides[k], next)) {
            return false;
        }
        offsets_[k].arc = *offset;
    }
    return true;
}

// Each offset crosses the next one once, to what is too near to it.
bool PlainInset::find_crossings() {
    for (std::size_t k = 0; k < count_; ++k) {
        Offset& offset = offsets_[k];
        Offset& next = offsets_[k + 1 < count_ ? k + 1 : 0];
        const Crossings there = crossings(offset.arc, next.arc);
        const Crossings back = crossings(next.arc, offset.arc);
        const bool is_once =
            !(there.entering > there.leaving && there.entering <= offset.arc.reach) &&
            !(back.leaving < back.entering && back.leaving >= -next.arc.reach);
        if (!is_once || !(std::abs(there.leaving) < offset.arc.reach) ||
            !(std::abs(back.entering) < next.arc.reach)) {
            return false;
        }
        offset.to = there.leaving;
        next.from = back.entering;
    }
    for (Offset& offset : std::span(offsets_).first(count_)) {
        if (!(offset.to - offset.from > kShortestPiece)) {
            return false;
        }
        offset.tail = point_at(offset.arc, offset.from);
    }
    return true;
}

// That every piece lies left of the offsets of all other sides: at its ends by p and q, between
// them by t p + (1 - t) q less what it and the other circle bend away from their chords, which is
// at most t (1 - t) c² (k + k') by the theorem of intersecting chords. That is not less than 0 if
// c² (k + k') <= (sqrt p + sqrt q)². With the offset of a side beside it a piece shares the point
// at one end; it cannot cross it again if the other end lies left of it.
bool PlainInset::keeps_distance(std::span<const SideArc> sides, double distance) const {
    for (std::size_t j = 0; j < count_; ++j) {
        const std::size_t before = j > 0 ? j - 1 : count_ - 1;
        double p = 0.0;  // at the corner where side j ends, which is its offset's
        for (std::size_t step = 1; step < count_; ++step) {
            const std::size_t k = j + step < count_ ? j + step : j + step - count_;
            const std::size_t corner = k + 1 < count_ ? k + 1 : 0;
            const double q =
                k == before ? 0.0 : least_distance_left(sides[j], offsets_[corner].tail) - distance;
            if (q < 0.0) {
                return false;
            }
            const bool is_beside = step == 1 || k == before;
            const double bend =
                (offsets_[corner].tail - offsets_[k].tail).squaredNorm() *
                (std::abs(offsets_[k].arc.curvature) + std::abs(sides[j].curvature));
            if (!is_beside && bend > p + q + 2.0 * std::min(p, q)) {
                return false;
            }
            p = q;
        }
    }
    return true;
}

}  // namespace foam::texgen
