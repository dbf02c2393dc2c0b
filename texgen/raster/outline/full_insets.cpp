// SPDX-License-Identifier: Apache-2.0

#include "texgen/raster/outline/full_insets.h"

#include "texgen/raster/coords/raster_grid.h"
#include "texgen/raster/outline/offset_arc.h"
#include "texgen/raster/simd/kernel.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <span>

namespace foam::texgen {

namespace {

// Limits on the half angle of a side (at most 60 degrees) and on the angle of the left turn from
// one side to the next (from 0.06 to 120 degrees). Within these limits, if a point of an offset is
// too near to the circle of an adjacent side, the nearest point of this circle is on that side, not
// beyond an end of the side.
constexpr double kMinSideCosine = 0.5;
constexpr double kMinCornerSine = 1e-3;
constexpr double kMinCornerCosine = -0.5;

constexpr std::size_t kLanes = 8;  // number of sides that keep_clear_of tests at once
template <class Number>
using Lanes = std::array<Number, kLanes>;

}  // namespace

// The stages of the computation. Each stage consists of loops over sides, which compilers
// vectorize.
struct FullInsets::Formulas {
    // Returns side k; its reach is not set.
    static OffsetArc side(const Columns& c, std::size_t k) {
        return {{c.middle_x[k], c.middle_y[k]},
                {c.along_x[k], c.along_y[k]},
                c.curvature[k],
                c.cosine[k],
                c.sine[k]};
    }

    // Returns the offset of side k.
    static OffsetArc offset(const Columns& c, std::size_t k) {
        return {{c.offset_x[k], c.offset_y[k]},
                {c.along_x[k], c.along_y[k]},
                c.offset_curvature[k],
                c.cosine[k],
                c.sine[k],
                c.offset_reach[k]};
    }

    static void offset_sides(Columns& c, std::size_t count, double distance) {
        for (std::size_t k = 0; k < count; ++k) {
            const Point chord(c.chord_x[k], c.chord_y[k]);
            const OffsetArc side =
                offset_arc_from(chord, c.cosine[k], c.sine[k], {c.tail_x[k], c.tail_y[k]});
            const OffsetArc offset = offset_left(side, distance);
            c.middle_x[k] = side.middle.x;
            c.middle_y[k] = side.middle.y;
            c.along_x[k] = side.direction.x;
            c.along_y[k] = side.direction.y;
            c.curvature[k] = side.curvature;
            c.offset_x[k] = offset.middle.x;
            c.offset_y[k] = offset.middle.y;
            c.offset_curvature[k] = offset.curvature;
            c.offset_reach[k] = offset.reach;
            const bool passes = and_nonshort(
                and_nonshort(chord.norm() > kShortestSide, side.cosine >= kMinSideCosine),
                shrinkage(side, distance) >= kSmallestShrinkage);
            c.passes_tests[k] = passes ? 1.0 : 0.0;
        }
    }

    // Cuts each offset and the next one at their crossing. Beyond the crossing, each of the two
    // offsets is too near to the side of the other offset. The first offset fails the tests if the
    // two do not cross exactly once, or if the turn between their sides is not within the limits.
    static void cut_corners(Columns& c, std::size_t count) {
        for (std::size_t k = 0; k + 1 < count; ++k) {
            const OffsetArc first = offset(c, k);
            const OffsetArc second = offset(c, k + 1);
            const Crossings ahead_crossings = crossings(first, second);
            const Crossings back_crossings = crossings(second, first);
            c.to[k] = ahead_crossings.leaving;
            c.from[k + 1] = back_crossings.entering;
            const Point ahead = head_tangent(first);
            const Point behind = tail_tangent(second);
            const bool turns_clearly_left = and_nonshort(cross(ahead, behind) > kMinCornerSine,
                                                         ahead.dot(behind) > kMinCornerCosine);
            const bool crosses_twice_ahead =
                and_nonshort(ahead_crossings.entering > ahead_crossings.leaving,
                             ahead_crossings.entering <= first.reach);
            const bool crosses_twice_back =
                and_nonshort(back_crossings.leaving < back_crossings.entering,
                             back_crossings.leaving >= -second.reach);
            const bool is_on_both = and_nonshort(std::abs(ahead_crossings.leaving) < first.reach,
                                                 std::abs(back_crossings.entering) < second.reach);
            const bool passes =
                and_nonshort(and_nonshort(turns_clearly_left, is_on_both),
                             and_nonshort(!crosses_twice_ahead, !crosses_twice_back));
            c.passes_tests[k] = passes ? c.passes_tests[k] : 0.0;
        }
    }

    // Computes the piece of each offset between its two cuts.
    static void compute_pieces(Columns& c, std::size_t count) {
        for (std::size_t k = 0; k < count; ++k) {
            const Point tail = point_at(offset(c, k), c.from[k]);
            const HalfAngle turn = half_angle_between(c.offset_curvature[k], c.from[k], c.to[k]);
            c.point_x[k] = tail.x;
            c.point_y[k] = tail.y;
            c.piece_cosine[k] = turn.cosine;
            c.piece_sine[k] = turn.sine;
            c.passes_tests[k] = c.to[k] - c.from[k] > kShortestPiece ? c.passes_tests[k] : 0.0;
        }
    }

    // Returns true if it is proven that every side of a loop is visible in the inset of the loop.
    static bool shows_every_side(const Columns& c, const Loop& loop, double distance) {
        double all_pass = loop.size >= kFewestSides ? 1.0 : 0.0;
        for (std::size_t k = 0; k < loop.size; ++k) {
            all_pass = min_value(all_pass, c.passes_tests[loop.begin + k]);
        }
        for (std::size_t first = 0; first < loop.size; first += kLanes) {
            all_pass = keep_clear_of(c, loop, first, distance) ? all_pass : 0.0;
        }
        return all_pass > 0.0;
    }

    // Returns true if all pieces of a loop have at least the given distance from each of the eight
    // sides that start at index `first` of the loop.
    //
    // Every piece must be on the left of the offsets of all other sides. Let p and q be the signed
    // distances of the two ends of a piece from the offset of another side, positive on the left of
    // this offset. Let c be the length of the chord of the piece, and k and k' the absolute
    // curvatures of the piece and of the other side. Let t be a fraction of the chord, counted from
    // the end with the distance q. The signed distance of the piece from the offset at this
    // fraction is at least t p + (1 - t) q - t (1 - t) c² (k + k'). By the intersecting chords
    // theorem, the last term is an upper bound of the deviations of both circles from their chords.
    // The signed distance is not negative for any t if c² (k + k') <= (sqrt p + sqrt q)². The code
    // compares with p + q + 2 min(p, q), which is at most the right-hand side.
    //
    // A piece and the offset of an adjacent side share one end. The piece and this offset do not
    // cross again if the other end of the piece is on the left of the offset.
    static bool keep_clear_of(const Columns& c,
                              const Loop& loop,
                              std::size_t first,
                              double distance) {
        const auto size = static_cast<std::int64_t>(loop.size);
        Lanes<std::int64_t> sides{};
        Lanes<std::int64_t> before{};
        Lanes<std::int64_t> after{};
        for (std::size_t lane = 0; lane < kLanes; ++lane) {
            const auto own = static_cast<std::int64_t>(first + lane);
            sides[lane] = own;
            before[lane] = own > 0 ? own - 1 : size - 1;
            after[lane] = own + 1 < size ? own + 1 : 0;
        }
        Lanes<double> p{};  // signed distances of the preceding point from the eight offsets
        p.fill(std::numeric_limits<double>::infinity());
        Lanes<std::int64_t> too_near{};
        const std::size_t begin = loop.begin;
        for (std::size_t k = 0; k <= loop.size; ++k) {
            const std::size_t last =
                k > 0 ? k - 1 : loop.size - 1;  // the piece that ends at point k
            const auto piece = static_cast<std::int64_t>(last);
            const Point point(c.point_x[begin + k], c.point_y[begin + k]);
            const Point tail(c.point_x[begin + last], c.point_y[begin + last]);
            const double squared_chord = (point - tail).squared_norm();
            const double own_curvature = std::abs(c.offset_curvature[begin + last]);
            for (std::size_t lane = 0; lane < kLanes; ++lane) {
                const OffsetArc other = side(c, begin + first + lane);
                const double q = distance_left(other, point) - distance;
                const double bend = squared_chord * (own_curvature + std::abs(other.curvature));
                const bool bends = bend > p[lane] + q + 2.0 * min_value(p[lane], q);
                const bool is_side = piece == sides[lane];
                const bool shares_tail = is_side | (piece == after[lane]);
                const bool shares_head = is_side | (piece == before[lane]);
                const bool is_too_near = (!shares_tail & (p[lane] < 0.0)) |
                                         (!shares_head & (q < 0.0)) |
                                         (!shares_tail & !shares_head & bends);
                too_near[lane] |= is_too_near ? 1 : 0;
                p[lane] = q;
            }
        }
        // Lanes beyond the last side of the loop do not contain sides of this loop, and are
        // ignored.
        std::int64_t any = 0;
        for (std::size_t lane = 0; lane < kLanes; ++lane) {
            any |= sides[lane] < size ? too_near[lane] : 0;
        }
        return any == 0;
    }
};

void FullInsets::trace(const ArcLoops& outlines, double distance) {
    const std::size_t count = fill_columns(outlines);
    at_simd_level([columns = columns_.get(),
                   count,
                   distance,
                   loops = loops_.data(),
                   loop_count = loops_.size()] {
        Columns& c = *columns;
        Formulas::offset_sides(c, count, distance);
        Formulas::cut_corners(c, count);
        for (std::size_t k = 0; k < loop_count; ++k) {
            c.from[loops[k].begin] = c.from[loops[k].begin + loops[k].size];
        }
        Formulas::compute_pieces(c, count);
        for (std::size_t k = 0; k < loop_count; ++k) {
            loops[k].shows_every_side = Formulas::shows_every_side(c, loops[k], distance);
        }
    });
}

// Copies the sides of loops to the columns. Leaves out loops of fewer than kFewestSides sides, and
// loops that do not fit. Returns the number of elements of each column that are in use, including
// the repeated first side of each loop.
std::size_t FullInsets::fill_columns(const ArcLoops& outlines) {
    Columns& c = *columns_;
    std::size_t count = 0;
    const auto append_side = [&](const ArcLoops::Side& side) {
        c.tail_x[count] = side.tail.x();
        c.tail_y[count] = side.tail.y();
        c.chord_x[count] = side.arc.chord.x();
        c.chord_y[count] = side.arc.chord.y();
        c.cosine[count] = side.arc.cosine;
        c.sine[count] = side.arc.sine;
        ++count;
    };
    loops_.clear();
    for (std::size_t k = 0; k < outlines.loop_ends.size(); ++k) {
        const std::span<const ArcLoops::Side> sides = outlines.loop(k);
        // The last block of kLanes sides may extend beyond the last side.
        const bool fits = count + sides.size() + 1 + kLanes <= kCapacity;
        if (sides.size() < kFewestSides || !fits) {
            loops_.push_back({});
            continue;
        }
        loops_.push_back({count, sides.size()});
        std::for_each(sides.begin(), sides.end(), append_side);
        append_side(sides.front());
    }
    return count;
}

void FullInsets::append_inset(std::size_t loop, ArcLoops& to) const {
    const Columns& c = *columns_;
    const std::size_t end = loops_[loop].begin + loops_[loop].size;
    for (std::size_t k = loops_[loop].begin; k < end; ++k) {
        const Vec2 tail(c.point_x[k], c.point_y[k]);
        const Vec2 head(c.point_x[k + 1], c.point_y[k + 1]);
        to.sides.push_back({tail, {head - tail, c.piece_cosine[k], c.piece_sine[k]}});
    }
    to.loop_ends.push_back(to.sides.size());
}

}  // namespace foam::texgen
