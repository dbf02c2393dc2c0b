// SPDX-License-Identifier: Apache-2.0

#include "texgen/raster/outline/inset.h"

#include "texgen/raster/coords/raster_grid.h"
#include "texgen/raster/outline/full_inset.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

// An inset is the erosion of a region by a disc (J. Serra, "Image Analysis and Mathematical
// Morphology", 1982). Like the method of W. Tiller and E. G. Hanson ("Offsets of two-dimensional
// profiles", 1984), this one cuts the offsets of sides at their crossings and discards the invalid
// parts. Two properties are our own: the method does not join the offsets of adjacent sides first,
// and it tests each piece by its distances from all sides. One test per piece suffices. The set of
// points that are too near to some side is bounded by offsets. Between two cuts, an offset is
// therefore too near to another side at all its points or at none.

namespace foam::texgen {

namespace {

// The value of InsetTracer::Offset::side for the offset of a corner.
constexpr std::size_t kCorner = std::numeric_limits<std::size_t>::max();

// A point counts as far enough from a side if its distance falls short of the required distance by
// at most this length, in pixels. Coordinates within a bubble have errors of about 1e-11 pixels,
// but crossings of arcs that meet at a small angle have errors of about 1e-7 pixels.
constexpr double kDistanceTolerance = 1e-7;
// Pieces of offsets (see the class InsetTracer) are linked into loops. Two pieces can be linked
// only if the tail of the second is less than this far, in pixels, from the head of the first. The
// limit is about one subpixel of the rasterizer (1 / kSubpixel pixels).
constexpr double kMaxGap = 1e-3;

// Returns false only if two arcs are certainly farther apart than `distance`.
bool may_be_within(const OffsetArc& a, const OffsetArc& b, double distance) {
    const double reach = extent(a) + extent(b) + distance;
    return (a.middle - b.middle).squaredNorm() <= reach * reach;
}

// Returns a disc that contains all points within `distance` of an arc.
Disc disc_around(const OffsetArc& arc, double distance) {
    return {arc.middle, extent(arc) + distance};
}

// Returns true if a boundary turns right by exactly 180 degrees. This happens at the end of a slit:
// the boundary runs along the slit to its end and back along its other side, with the region on
// both sides.
bool turns_back(const OffsetArc& before, const OffsetArc& after) {
    const Vec2 from = head_tangent(before);
    const Vec2 to = tail_tangent(after);
    return cross(from, to) == 0.0 && from.dot(to) < 0.0;
}

}  // namespace

const ArcLoops& InsetTracer::trace(const ArcLoops& region, double distance) {
    distance_ = distance;
    sides_.clear();
    offsets_.clear();
    pieces_.clear();
    loops_.clear();
    for (std::size_t k = 0; k < region.loop_ends.size(); ++k) {
        add_loop(region.loop(k));
    }
    side_index_.build(sides_.size(), [&](std::size_t k) { return disc_around(sides_[k], 0.0); });
    offset_index_.build(offsets_.size(),
                        [&](std::size_t k) { return disc_around(offsets_[k].arc, 0.0); });
    for (std::size_t k = 0; k < offsets_.size(); ++k) {
        collect_pieces(k);
    }
    piece_index_.build(pieces_.size(), [&](std::size_t k) { return Disc{pieces_[k].tail, 0.0}; });
    for (Piece& piece : pieces_) {
        if (!piece.linked) {
            link_loop(piece);
        }
    }
    return loops_;
}

const ArcLoops& InsetTracer::trace_loop(const ArcLoops& region, std::size_t loop, double distance) {
    const std::span<const ArcLoops::Side> sides = region.loop(loop);
    return trace({{sides.begin(), sides.end()}, {sides.size()}}, distance);
}

// Stores the sides of a loop and their offsets.
void InsetTracer::add_loop(std::span<const ArcLoops::Side> loop) {
    const std::size_t first = sides_.size();
    for (const ArcLoops::Side& side : loop) {
        if (side.arc.chord.norm() > kShortestChord) {
            sides_.push_back(offset_arc_from(side.arc, side.tail));
        }
    }
    for (std::size_t k = first; k < sides_.size(); ++k) {
        const OffsetArc& side = sides_[k];
        const OffsetArc& next = sides_[k + 1 < sides_.size() ? k + 1 : first];
        if (shrinkage(side, distance_) >= kMinShrinkage) {
            offsets_.push_back({offset_left(side, distance_), k});
        }
        if (turns_right(side, next) || turns_back(side, next)) {
            offsets_.push_back({corner_arc(side, next, distance_), kCorner});
        }
    }
}

void InsetTracer::collect_cuts(const Offset& offset) {
    const OffsetArc& arc = offset.arc;
    cuts_ = {-arc.reach, arc.reach};
    for (const std::size_t k : offset_index_.near(disc_around(arc, kDistanceTolerance))) {
        const Offset& other = offsets_[k];
        if (&other == &offset || !may_be_within(arc, other.arc, kDistanceTolerance)) {
            continue;
        }
        const Crossings found = crossings(arc, other.arc);
        for (const double at : {found.leaving, found.entering}) {
            if (std::abs(at) < arc.reach) {
                cuts_.push_back(at);
            }
        }
    }
    std::sort(cuts_.begin(), cuts_.end());
}

void InsetTracer::collect_nearby(const Offset& offset) {
    nearby_.clear();
    for (const std::size_t k : side_index_.near(disc_around(offset.arc, distance_))) {
        if (k != offset.side && may_be_within(offset.arc, sides_[k], distance_)) {
            nearby_.push_back(k);
        }
    }
}

bool InsetTracer::keeps_distance(const Vec2& point) const {
    return std::all_of(nearby_.begin(), nearby_.end(), [&](std::size_t k) {
        return texgen::distance(sides_[k], point) >= distance_ - kDistanceTolerance;
    });
}

void InsetTracer::collect_pieces(std::size_t index) {
    const OffsetArc& arc = offsets_[index].arc;
    collect_cuts(offsets_[index]);
    collect_nearby(offsets_[index]);
    bool continues = false;  // true if the last tested piece was kept
    for (std::size_t k = 0; k + 1 < cuts_.size(); ++k) {
        const double from = cuts_[k];
        const double to = cuts_[k + 1];
        if (to - from < kShortestPiece) {
            continue;
        }
        const bool kept = keeps_distance(point_at(arc, 0.5 * (from + to)));
        if (kept && continues) {
            pieces_.back().to = to;
            pieces_.back().head = point_at(arc, to);
        } else if (kept) {
            pieces_.push_back({index, from, to, point_at(arc, from), point_at(arc, to), false});
        }
        continues = kept;
    }
}

// Returns the piece that follows `piece` in a loop: the candidate whose tail is nearest to the head
// of `piece`. Candidates are all pieces that are not linked yet, and the first piece of the loop.
// Returns null if the tail of no candidate is within kMaxGap of the head.
InsetTracer::Piece* InsetTracer::successor(const Piece& piece, const Piece& first) {
    Piece* nearest = nullptr;
    double min_gap = kMaxGap * kMaxGap;
    for (const std::size_t k : piece_index_.near({piece.head, kMaxGap})) {
        Piece& candidate = pieces_[k];
        const double gap = (candidate.tail - piece.head).squaredNorm();
        if (gap < min_gap && (!candidate.linked || &candidate == &first)) {
            min_gap = gap;
            nearest = &candidate;
        }
    }
    return nearest;
}

void InsetTracer::link_loop(Piece& first) {
    const std::size_t begin = loops_.sides.size();
    Piece* current = &first;
    do {
        current->linked = true;
        Piece* next = successor(*current, first);
        if (next == nullptr) {
            ++loops_.unclosed_loops;
            loops_.sides.resize(begin);
            return;
        }
        const OffsetArc& arc = offsets_[current->offset].arc;
        const HalfAngle turn = half_angle_between(arc.curvature, current->from, current->to);
        loops_.sides.push_back(
            {current->tail, {next->tail - current->tail, turn.cosine, turn.sine}});
        current = next;
    } while (current != &first);
    loops_.loop_ends.push_back(loops_.sides.size());
}

}  // namespace foam::texgen
