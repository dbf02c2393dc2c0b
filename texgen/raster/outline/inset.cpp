#include "texgen/raster/outline/inset.h"

#include "texgen/raster/coords/raster_grid.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>

namespace foam::texgen {

namespace {

constexpr std::size_t kCorner = std::numeric_limits<std::size_t>::max();

// In pixels. Coordinates within a bubble are good to 1e-11, crossings of arcs that touch at a small
// angle to some 1e-7. Ends that belong together are found within less than a subpixel.
constexpr double kDistanceTolerance = 1e-7;
constexpr double kLargestGap = 1e-3;

bool within(const OffsetArc& a, const OffsetArc& b, double distance) {
    const double reach = extent(a) + extent(b) + distance;
    return (a.middle - b.middle).squaredNorm() <= reach * reach;
}

}  // namespace

void InsetTracer::clear() {
    all_sides_.clear();
    all_loop_ends_.clear();
}

void InsetTracer::add_side(const PixelArc& side, const Vec2& tail) {
    if (side.chord.norm() > kShortestSide) {
        all_sides_.push_back(place(side, tail));
    }
}

void InsetTracer::end_loop() {
    all_loop_ends_.push_back(all_sides_.size());
}

const ArcLoops& InsetTracer::trace(double distance) {
    return trace(all_sides_, all_loop_ends_, distance);
}

const ArcLoops& InsetTracer::trace_loop(std::size_t loop, double distance) {
    const std::size_t begin = loop == 0 ? 0 : all_loop_ends_[loop - 1];
    const std::size_t size = all_loop_ends_[loop] - begin;
    return trace(std::span(all_sides_).subspan(begin, size), std::array{size}, distance);
}

const ArcLoops& InsetTracer::trace(std::span<const OffsetArc> sides,
                                   std::span<const std::size_t> loop_ends,
                                   double distance) {
    sides_ = sides;
    distance_ = distance;
    loops_.sides.clear();
    loops_.loop_ends.clear();
    loops_.open_ends = 0;
    if (loop_ends.size() != 1 || !full_inset_.trace(sides, distance, loops_)) {
        trace_pieces(loop_ends);
    }
    return loops_;
}

void InsetTracer::trace_pieces(std::span<const std::size_t> loop_ends) {
    pieces_.clear();
    offsets_.clear();
    std::size_t first = 0;
    for (const std::size_t end : loop_ends) {
        collect_offsets(first, end);
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
}

void InsetTracer::collect_offsets(std::size_t first, std::size_t end) {
    for (std::size_t k = first; k < end; ++k) {
        const OffsetArc& side = sides_[k];
        const OffsetArc& next = sides_[k + 1 < end ? k + 1 : first];
        if (shrinkage(side, distance_) >= kSmallestShrinkage) {
            offsets_.push_back({offset_left(side, distance_), k});
        }
        if (turns_right(side, next)) {
            offsets_.push_back({corner_arc(side, next, distance_), kCorner});
        }
    }
}

void InsetTracer::collect_cuts(const Offset& offset) {
    const OffsetArc& arc = offset.arc;
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
    const OffsetArc& arc = offsets_[index].arc;
    collect_cuts(offsets_[index]);
    collect_nearby(offsets_[index]);
    bool continues = false;  // the piece before ends where this one begins
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

// Returns the piece that begins nearest to where this one ends: one that is still free, or the
// first of the loop.
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
    const std::size_t begin = loops_.sides.size();
    Piece* current = &first;
    do {
        current->linked = true;
        Piece* next = successor(*current, first);
        if (next == nullptr) {
            ++loops_.open_ends;
            loops_.sides.resize(begin);
            return;
        }
        const OffsetArc& arc = offsets_[current->offset].arc;
        loops_.sides.push_back(
            {current->tail, piece(arc, current->from, current->to, next->tail - current->tail)});
        current = next;
    } while (current != &first);
    loops_.loop_ends.push_back(loops_.sides.size());
}

}  // namespace foam::texgen
