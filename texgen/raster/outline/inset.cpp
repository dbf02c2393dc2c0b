#include "texgen/raster/outline/inset.h"

#include "texgen/raster/coords/raster_grid.h"
#include "texgen/raster/simd/kernel.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>

namespace foam::texgen {

namespace {

constexpr std::size_t kCorner = std::numeric_limits<std::size_t>::max();

// In pixels. Coordinates within a bubble are good to 1e-11, crossings of arcs that touch at a small
// angle to some 1e-7. A piece is long enough that its middle, in front of a side that leans on it,
// is seen to be too near; ends that belong together are found within less than a subpixel.
constexpr double kShortestPiece = 1e-6;
constexpr double kDistanceTolerance = 1e-7;
constexpr double kLargestGap = 1e-3;

// Bounds within which the nearest points of two sides that meet lie on the sides themselves: of
// half the angle that a side turns, and of the angle that they turn by where they meet.
constexpr double kLeastSideCosine = 0.5;
constexpr double kLeastCornerSine = 1e-3;
constexpr double kLeastCornerCosine = -0.5;

bool turns_right(const OffsetArc& before, const OffsetArc& after) {
    return cross(head_tangent(before), tail_tangent(after)) < 0.0;
}

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
    loops_.arcs.clear();
    loops_.loop_ends.clear();
    loops_.open_ends = 0;
    if (loop_ends.size() == 1 && every_side_shows()) {
        append_all_sides();
    } else {
        trace_pieces(loop_ends);
    }
    return loops_;
}

bool InsetTracer::every_side_shows() {
    constexpr std::size_t kFewestSides = 3;
    if (sides_.size() < kFewestSides || !cut_by_neighbors()) {
        return false;
    }
    place_lanes();
    return pieces_keep_clear();
}

bool InsetTracer::cut_by_neighbors() {
    const std::size_t count = sides_.size();
    offsets_.clear();
    for (std::size_t k = 0; k < count; ++k) {
        const OffsetArc& side = sides_[k];
        if (side.cosine < kLeastSideCosine || shrinkage(side, distance_) < kSmallestShrinkage) {
            return false;
        }
        offsets_.push_back({offset_left(side, distance_), k});
    }
    for (std::size_t k = 0; k < count; ++k) {
        if (!cut_corner(k, k + 1 < count ? k + 1 : 0)) {
            return false;
        }
    }
    return std::all_of(offsets_.begin(), offsets_.end(), [](const Offset& offset) {
        return offset.to - offset.from > kShortestPiece;
    });
}

// Returns true if the offset of a side crosses the next one once, to the side on which it is too
// near to the next.
bool InsetTracer::cut_corner(std::size_t before, std::size_t after) {
    const Vec2 from = head_tangent(sides_[before]);
    const Vec2 to = tail_tangent(sides_[after]);
    Offset& first = offsets_[before];
    Offset& second = offsets_[after];
    const Crossings there = crossings(first.arc, second.arc);
    const Crossings back = crossings(second.arc, first.arc);
    first.to = there.leaving;
    second.from = back.entering;
    const bool turns_plainly =
        and_nonshort(cross(from, to) > kLeastCornerSine, from.dot(to) > kLeastCornerCosine);
    const bool again_there =
        and_nonshort(there.entering > there.leaving, there.entering <= first.arc.reach);
    const bool again_back =
        and_nonshort(back.leaving < back.entering, back.leaving >= -second.arc.reach);
    const bool is_on_both = and_nonshort(std::abs(there.leaving) < first.arc.reach,
                                         std::abs(back.entering) < second.arc.reach);
    return and_nonshort(and_nonshort(turns_plainly, is_on_both),
                        and_nonshort(!again_there, !again_back));
}

// Places the sides in lanes, the last block filled up with copies of the first side, and the points
// where one piece ends and the next begins.
void InsetTracer::place_lanes() {
    const std::size_t count = sides_.size();
    points_.clear();
    for (const Offset& offset : offsets_) {
        points_.push_back(point_at(offset.arc, offset.from));
    }
    points_.push_back(points_.front());
    const std::size_t blocks = (count + kLanes - 1) / kLanes;
    grow(lanes_, blocks);
    for (std::size_t lane = 0; lane < blocks * kLanes; ++lane) {
        lanes_[lane / kLanes].set(lane % kLanes, sides_, lane < count ? lane : 0);
    }
}

void InsetTracer::SideLanes::set(std::size_t lane,
                                 std::span<const OffsetArc> sides,
                                 std::size_t index) {
    const auto own = static_cast<std::int64_t>(index);
    const auto count = static_cast<std::int64_t>(sides.size());
    const OffsetArc& arc = sides[index];
    x[lane] = arc.middle.x();
    y[lane] = arc.middle.y();
    along_x[lane] = arc.direction.x();
    along_y[lane] = arc.direction.y();
    curvature[lane] = arc.curvature;
    side[lane] = own;
    before[lane] = own > 0 ? own - 1 : count - 1;
    after[lane] = own + 1 < count ? own + 1 : 0;
}

// Every piece has to be on the left of the offsets of all other sides. At its ends it is p and q to
// the left; between them, t p + (1 - t) q less what the piece and the other circle bend away from
// their chords. That is at most t (1 - t) c² (k + k') by the theorem of intersecting chords, so
// that c² (k + k') <= (sqrt p + sqrt q)² suffices. With the offset of a neighbor a piece shares one
// end, and does not cross it again if the other end is on its left.
bool InsetTracer::pieces_keep_clear() {
    return at_simd_level([this] {
        std::int64_t too_near = 0;
        for (std::size_t block = 0; block * kLanes < sides_.size(); ++block) {
            too_near |= pieces_too_near(lanes_[block]);
        }
        return too_near == 0;
    });
}

inline std::int64_t InsetTracer::pieces_too_near(const SideLanes& sides) const {
    const double distance = distance_;
    std::array<double, kLanes> p{};  // of the last point
    p.fill(std::numeric_limits<double>::infinity());
    std::array<std::int64_t, kLanes> too_near{};
    for (std::size_t k = 0; k < points_.size(); ++k) {
        const std::size_t last = k > 0 ? k - 1 : offsets_.size() - 1;  // piece that ends here
        const auto piece = static_cast<std::int64_t>(last);
        const double squared_chord = (points_[k] - points_[last]).squaredNorm();
        const double own_curvature = std::abs(offsets_[last].arc.curvature);
        const double point_x = points_[k].x();
        const double point_y = points_[k].y();
        for (std::size_t lane = 0; lane < kLanes; ++lane) {
            const double q = distance_left(sides.along_x[lane],
                                           sides.along_y[lane],
                                           sides.curvature[lane],
                                           point_x - sides.x[lane],
                                           point_y - sides.y[lane]) -
                             distance;
            const double bend = squared_chord * (own_curvature + std::abs(sides.curvature[lane]));
            const bool bends = bend > p[lane] + q + 2.0 * min_value(p[lane], q);
            const bool is_side = piece == sides.side[lane];
            const bool is_after = piece == sides.after[lane];
            const bool is_before = piece == sides.before[lane];
            const bool shares_tail = is_side | is_after;
            const bool shares_head = is_side | is_before;
            const bool is_too_near = (!shares_tail & (p[lane] < 0.0)) | (!shares_head & (q < 0.0)) |
                                     (!shares_tail & !shares_head & bends);
            too_near[lane] |= is_too_near ? 1 : 0;
            p[lane] = q;
        }
    }
    std::int64_t any = 0;
    for (const std::int64_t one : too_near) {
        any |= one;
    }
    return any;
}

void InsetTracer::append_all_sides() {
    for (std::size_t k = 0; k < offsets_.size(); ++k) {
        const Offset& offset = offsets_[k];
        const Vec2 chord = points_[k + 1] - points_[k];
        loops_.arcs.push_back({points_[k], piece(offset.arc, offset.from, offset.to, chord)});
    }
    loops_.loop_ends.push_back(loops_.arcs.size());
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
        const OffsetArc& arc = offsets_[current->offset].arc;
        loops_.arcs.push_back(
            {current->tail, piece(arc, current->from, current->to, next->tail - current->tail)});
        current = next;
    } while (current != &first);
    loops_.loop_ends.push_back(loops_.arcs.size());
}

}  // namespace foam::texgen
