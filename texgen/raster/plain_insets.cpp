#include "texgen/raster/plain_insets.h"

#include "texgen/raster/arcs/monotone.h"
#include "texgen/raster/coords/raster_grid.h"
#include "texgen/raster/side_arc.h"
#include "texgen/raster/simd/vector_clones.h"

#include <cmath>

namespace foam::texgen {

namespace {

constexpr double kLeastSideCosine = 0.5;  // of half the angle that a side turns
// What two sides turn by where they meet, at least and at most: then the nearest points of both
// lie on the sides themselves.
constexpr double kLeastSine = 1e-3;
constexpr double kLeastCosine = -0.5;

// Why an inset may not be plain.
constexpr std::int64_t kMayBend = 1;  // too near to a side, between its ends
constexpr std::int64_t kNotPlain = 2;

constexpr double kFar = 1 << 16;  // beyond what can be rounded; where nothing crosses

}  // namespace

void PlainInsets::trace(double distance) {
    place_offsets(distance);
    cross_offsets();
    for (std::size_t b = 0; b < bubbles_; ++b) {
        from_[begin(b)] = from_[end(b)];
    }
    cut_offsets();
    join_arcs();
    copy_arcs();
    measure_distances(distance);
    for (std::size_t b = 0; b < bubbles_; ++b) {
        certain_[b] = decide(b);
    }
}

// As `place` and `offset_left` do.
FOAMTEX_VECTOR_CLONES void PlainInsets::place_offsets(double distance) {
    const std::size_t count = lanes();
    for (std::size_t k = 0; k < count; ++k) {
        const double x = chord_x_[k];
        const double y = chord_y_[k];
        const double c = side_cosine_[k];
        const double s = side_sine_[k];
        const double length = std::sqrt(x * x + y * y);
        const double along_x = x / length;
        const double along_y = y / length;
        const double curvature = 2.0 * s / length;
        const double reach = length / (1.0 + c);
        const double middle_x = side_tail_x_[k] + 0.5 * (x + reach * s * along_y);
        const double middle_y = side_tail_y_[k] + 0.5 * (y - reach * s * along_x);
        const double shrinkage = 1.0 - curvature * distance;
        along_x_[k] = along_x;
        along_y_[k] = along_y;
        tail_along_x_[k] = c * along_x + s * along_y;
        tail_along_y_[k] = c * along_y - s * along_x;
        head_along_x_[k] = c * along_x - s * along_y;
        head_along_y_[k] = c * along_y + s * along_x;
        curvature_[k] = curvature;
        middle_x_[k] = middle_x;
        middle_y_[k] = middle_y;
        offset_x_[k] = middle_x - distance * along_y;
        offset_y_[k] = middle_y + distance * along_x;
        offset_curvature_[k] = curvature / shrinkage;
        reach_[k] = reach * shrinkage;
        const bool is_plain =
            (length > kShortestSide) & (shrinkage >= kSmallestShrinkage) & (c >= kLeastSideCosine);
        corner_doubts_[k] = is_plain ? 0 : kNotPlain;
    }
}

// Each offset crosses the next one once, to what is too near to it.
FOAMTEX_VECTOR_CLONES void PlainInsets::cross_offsets() {
    const std::size_t count = lanes();
    for (std::size_t k = 0; k + 1 < count; ++k) {
        const std::size_t n = k + 1;
        const double sine =
            head_along_x_[k] * tail_along_y_[n] - head_along_y_[k] * tail_along_x_[n];
        const double cosine =
            head_along_x_[k] * tail_along_x_[n] + head_along_y_[k] * tail_along_y_[n];
        const Crossings there = crossings(offset_circle(k), offset_circle(n));
        const Crossings back = crossings(offset_circle(n), offset_circle(k));
        const bool turns_plainly = and_nonshort(sine > kLeastSine, cosine > kLeastCosine);
        const bool again_there =
            and_nonshort(there.entering > there.leaving, there.entering <= reach_[k]);
        const bool again_back =
            and_nonshort(back.leaving < back.entering, back.leaving >= -reach_[n]);
        const bool is_once = and_nonshort(!again_there, !again_back);
        const bool is_on_both =
            and_nonshort(std::abs(there.leaving) < reach_[k], std::abs(back.entering) < reach_[n]);
        const bool is_plain = and_nonshort(turns_plainly, and_nonshort(is_once, is_on_both));
        corner_doubts_[k] |= is_plain ? 0 : kNotPlain;
        to_[k] = there.leaving;
        from_[n] = back.entering;
    }
}

// As `point_at` and `piece` do.
FOAMTEX_VECTOR_CLONES void PlainInsets::cut_offsets() {
    const std::size_t count = lanes();
    for (std::size_t k = 0; k < count; ++k) {
        const double from = from_[k];
        const double to = to_[k];
        const double half = 0.5 * offset_curvature_[k];
        const double tangent = half * from;
        const double scale = from / (1.0 + tangent * tangent);
        tail_x_[k] = offset_x_[k] + scale * (along_x_[k] - tangent * along_y_[k]);
        tail_y_[k] = offset_y_[k] + scale * (along_y_[k] + tangent * along_x_[k]);
        const double sine = half * (to - from);
        const double cosine = 1.0 + half * half * from * to;
        const double over = 1.0 / std::sqrt(sine * sine + cosine * cosine);
        cosine_[k] = cosine * over;
        sine_[k] = sine * over;
        corner_doubts_[k] |= to - from > kShortestPiece ? 0 : kNotPlain;
    }
}

FOAMTEX_VECTOR_CLONES void PlainInsets::join_arcs() {
    const std::size_t count = lanes();
    for (std::size_t k = 0; k + 1 < count; ++k) {
        const double x = tail_x_[k + 1] - tail_x_[k];
        const double y = tail_y_[k + 1] - tail_y_[k];
        ahead_x_[k] = x;
        ahead_y_[k] = y;
        monotone_[k] = texgen::is_monotone(x, y, cosine_[k], sine_[k]) ? 1 : 0;
    }
    for (std::size_t k = 0; k < count; ++k) {
        const bool is_near = and_nonshort(std::abs(tail_x_[k]) < kFar, std::abs(tail_y_[k]) < kFar);
        rounded_x_[k] = to_subpixel(is_near ? tail_x_[k] : 0.0);
        rounded_y_[k] = to_subpixel(is_near ? tail_y_[k] : 0.0);
    }
}

[[gnu::always_inline]] inline void PlainInsets::copy_round(std::size_t bubble, std::size_t to) {
    double* __restrict x = round_x_.data() + to;
    double* __restrict y = round_y_.data() + to;
    double* __restrict curvature = round_curvature_.data() + to;
    for (std::size_t block = begin(bubble); block < end(bubble); block += kBlock) {
        for (std::size_t k = 0; k < kBlock; ++k) {
            x[k] = tail_x_[block + k];
            y[k] = tail_y_[block + k];
            curvature[k] = std::abs(offset_curvature_[block + k]);
        }
        x += kBlock;
        y += kBlock;
        curvature += kBlock;
    }
}

// What lies beyond the second round is that of the next bubble, which comes later.
FOAMTEX_VECTOR_CLONES void PlainInsets::copy_arcs() {
    for (std::size_t b = 0; b < bubbles_; ++b) {
        copy_round(b, 2 * begin(b));
        copy_round(b, begin(b) + end(b));
    }
}

// That every piece lies left of the offsets of all other sides: at its ends by p and q, between
// them by t p + (1 - t) q less what it and the other circle bend away from their chords, which is
// at most t (1 - t) c² (k + k') by the theorem of intersecting chords. That is not less than 0 if
// c² (k + k') <= (sqrt p + sqrt q)². With the offset of a side beside it a piece shares the point
// at one end; it cannot cross it again if the other end lies left of it.
[[gnu::always_inline]] inline void PlainInsets::measure_distances(std::size_t bubble,
                                                                  double distance) {
    const std::size_t sides = end(bubble) - begin(bubble);
    std::int64_t all = 0;
    for (std::size_t block = 0; block < sides; block += kBlock) {
        const std::size_t first = begin(bubble) + block;
        const std::size_t round = 2 * begin(bubble) + block;
        std::array<double, kBlock> p{};
        std::array<double, kBlock> from_x{};
        std::array<double, kBlock> from_y{};
        std::array<std::int64_t, kBlock> doubts{};
        for (std::size_t k = 0; k < kBlock; ++k) {
            doubts[k] = corner_doubts_[first + k];
        }
        for (std::size_t step = 1; step + 1 < sides; ++step) {
            const std::size_t piece = round + step;
            const std::int64_t may_bend = step > 1 ? kMayBend : 0;  // not of the piece beside
            for (std::size_t k = 0; k < kBlock; ++k) {
                const double x = round_x_[piece + k + 1] - middle_x_[first + k];
                const double y = round_y_[piece + k + 1] - middle_y_[first + k];
                const double curvature = curvature_[first + k];
                const double f = along_x_[first + k] * y - along_y_[first + k] * x -
                                 0.5 * curvature * (x * x + y * y);
                const double less = f / (1.0 - 0.5 * curvature * f);
                const double q = (((curvature >= 0.0) | (f <= 0.0)) ? f : less) - distance;
                const double dx = x - from_x[k];
                const double dy = y - from_y[k];
                const double bend =
                    (dx * dx + dy * dy) * (round_curvature_[piece + k] + std::abs(curvature));
                const double least = p[k] < q ? p[k] : q;
                doubts[k] |=
                    (bend > p[k] + q + 2.0 * least ? may_bend : 0) | (q < 0.0 ? kNotPlain : 0);
                p[k] = q;
                from_x[k] = x;
                from_y[k] = y;
            }
        }
        for (std::size_t k = 0; k < kBlock; ++k) {
            side_doubts_[first + k] = doubts[k];
            all |= block + k < sides ? doubts[k] : 0;
        }
    }
    doubts_[bubble] = all;
}

FOAMTEX_VECTOR_CLONES void PlainInsets::measure_distances(double distance) {
    for (std::size_t b = 0; b < bubbles_; ++b) {
        measure_distances(b, distance);
    }
}

bool PlainInsets::decide(std::size_t bubble) const {
    if (end(bubble) - begin(bubble) < 3 || (doubts_[bubble] & kNotPlain) != 0) {
        return false;
    }
    for (std::size_t k = begin(bubble); doubts_[bubble] != 0 && k < end(bubble); ++k) {
        if (side_doubts_[k] != 0 && !keeps_clear(bubble, k)) {
            return false;
        }
    }
    return true;
}

// What bends towards a side's offset, its ends on the left of it, keeps clear if it does not cross
// the whole circle.
bool PlainInsets::keeps_clear(std::size_t bubble, std::size_t side) const {
    const std::size_t sides = end(bubble) - begin(bubble);
    for (std::size_t step = 2; step + 2 <= sides; ++step) {
        const std::size_t k = side + step < end(bubble) ? side + step : side + step - sides;
        const Crossings found = crossings(offset_circle(k), offset_circle(side));
        for (const double at : {found.leaving, found.entering}) {
            if (at >= from_[k] && at <= to_[k]) {
                return false;
            }
        }
    }
    return true;
}

}  // namespace foam::texgen
