#include "texgen/raster/inset.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>

namespace foam::texgen {

namespace {

constexpr std::size_t kCorner = std::numeric_limits<std::size_t>::max();

// In pixels. Coordinates within a bubble are good to 1e-11, crossings of arcs that touch at a small
// angle to some 1e-7. A piece is longer than kShortestPiece, so that its middle, in front of a side
// that leans on it, is seen to be too near; ends that belong together are found within less than a
// subpixel.
constexpr double kDistanceTolerance = 1e-7;
constexpr double kLargestGap = 1e-3;

bool turns_right(const SideArc& before, const SideArc& after) {
    return cross(before.head_tangent, after.tail_tangent) < 0.0;
}

bool within(const SideArc& a, const SideArc& b, double distance) {
    const double reach = a.extent + b.extent + distance;
    return (a.middle - b.middle).squaredNorm() <= reach * reach;
}

}  // namespace

const ArcLoops& InsetTracer::trace(std::span<const SideArc> sides, double distance) {
    return trace(sides, std::array{sides.size()}, distance);
}

void InsetTracer::begin() {
    loops_.arcs.clear();
    loops_.loop_ends.clear();
    loops_.open_ends = 0;
}

const ArcLoops& InsetTracer::trace(std::span<const SideArc> sides,
                                   std::span<const std::size_t> loop_ends,
                                   double distance) {
    sides_ = sides;
    distance_ = distance;
    begin();
    pieces_.clear();
    offsets_.clear();
    std::size_t first = 0;
    for (const std::size_t end : loop_ends) {
        collect_offsets(sides.subspan(first, end - first), first);
        first = end;
    }
    for (std::size_t k = 0; k < offsets_.size(); ++k) {
        collect_pieces(k);
    }
    for (Piece& piece : pieces_) {
        if (!piece.linked) {
            link_loop(piece);
        }
    }
    return loops_;
}

void InsetTracer::collect_offsets(std::span<const SideArc> loop, std::size_t first_side) {
    for (std::size_t k = 0; k < loop.size(); ++k) {
        const SideArc& side = loop[k];
        const SideArc& next = loop[(k + 1) % loop.size()];
        if (const std::optional<SideArc> offset = offset_left(side, distance_)) {
            offsets_.push_back({*offset, first_side + k});
        }
        if (turns_right(side, next)) {
            offsets_.push_back({corner_arc(side, next, distance_), kCorner});
        }
    }
}

void InsetTracer::collect_cuts(const Offset& offset) {
    const SideArc& arc = offset.arc;
    cuts_ = {-arc.reach, arc.reach};
    for (const Offset& other : offsets_) {
        if (&other == &offset || !within(arc, other.arc, kDistanceTolerance)) {
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
    for (std::size_t k = 0; k < sides_.size(); ++k) {
        if (k != offset.side && within(offset.arc, sides_[k], distance_)) {
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
    const Offset& offset = offsets_[index];
    collect_cuts(offset);
    collect_nearby(offset);
    bool continues = false;  // the piece before ends where this one begins
    for (std::size_t k = 0; k + 1 < cuts_.size(); ++k) {
        const double from = cuts_[k];
        const double to = cuts_[k + 1];
        if (to - from < kShortestPiece) {
            continue;
        }
        const bool kept = keeps_distance(point_at(offset.arc, 0.5 * (from + to)));
        if (kept && continues) {
            pieces_.back().to = to;
            pieces_.back().head = point_at(offset.arc, to);
        } else if (kept) {
            pieces_.push_back(
                {index, from, to, point_at(offset.arc, from), point_at(offset.arc, to), false});
        }
        continues = kept;
    }
}

// The piece that begins nearest to where this one ends: one that is still free, or the loop's
// first.
InsetTracer::Piece* InsetTracer::successor(const Piece& piece, const Piece& first) {
    Piece* nearest = nullptr;
    double least = kLargestGap * kLargestGap;
    for (Piece& candidate : pieces_) {
        const double gap = (candidate.tail - piece.head).squaredNorm();
        if (gap < least && (!candidate.linked || &candidate == &first)) {
            least = gap;
            nearest = &candidate;
        }
    }
    return nearest;
}

void InsetTracer::link_loop(Piece& first) {
    const std::size_t begin = loops_.arcs.size();
    Piece* current = &first;
    do {
        current->linked = true;
        Piece* next = successor(*current, first);
        if (next == nullptr) {
            ++loops_.open_ends;
            loops_.arcs.resize(begin);
            return;
        }
        PixelArc arc = piece(offsets_[current->offset].arc, current->from, current->to);
        arc.chord = next->tail - current->tail;
        loops_.arcs.push_back({current->tail, arc});
        current = next;
    } while (current != &first);
    loops_.loop_ends.push_back(loops_.arcs.size());
}

}  // namespace foam::texgen
