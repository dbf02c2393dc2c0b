#include "texgen/raster/outline/full_inset.h"

#include "texgen/raster/simd/kernel.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace foam::texgen {

namespace {

// Bounds within which the nearest points of two sides that meet lie on the sides themselves: of
// half the angle that a side turns, and of the angle that they turn by where they meet.
constexpr double kLeastSideCosine = 0.5;
constexpr double kLeastCornerSine = 1e-3;
constexpr double kLeastCornerCosine = -0.5;

}  // namespace

bool FullInset::trace(std::span<const OffsetArc> sides, double distance, ArcLoops& loops) {
    constexpr std::size_t kFewestSides = 3;
    sides_ = sides;
    distance_ = distance;
    if (sides.size() < kFewestSides || !cut_by_neighbors()) {
        return false;
    }
    place_lanes();
    if (!pieces_keep_clear()) {
        return false;
    }
    append_to(loops);
    return true;
}

bool FullInset::cut_by_neighbors() {
    const std::size_t count = sides_.size();
    offsets_.clear();
    for (std::size_t k = 0; k < count; ++k) {
        const OffsetArc& side = sides_[k];
        if (side.cosine < kLeastSideCosine || shrinkage(side, distance_) < kSmallestShrinkage) {
            return false;
        }
        offsets_.push_back({offset_left(side, distance_)});
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
bool FullInset::cut_corner(std::size_t before, std::size_t after) {
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
void FullInset::place_lanes() {
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

void FullInset::SideLanes::set(std::size_t lane,
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
bool FullInset::pieces_keep_clear() {
    return at_simd_level([this] {
        std::int64_t too_near = 0;
        for (std::size_t block = 0; block * kLanes < sides_.size(); ++block) {
            too_near |= pieces_too_near(lanes_[block]);
        }
        return too_near == 0;
    });
}

inline std::int64_t FullInset::pieces_too_near(const SideLanes& sides) const {
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

void FullInset::append_to(ArcLoops& loops) const {
    for (std::size_t k = 0; k < offsets_.size(); ++k) {
        const Offset& offset = offsets_[k];
        const Vec2 chord = points_[k + 1] - points_[k];
        loops.sides.push_back({points_[k], piece(offset.arc, offset.from, offset.to, chord)});
    }
    loops.loop_ends.push_back(loops.sides.size());
}

}  // namespace foam::texgen
