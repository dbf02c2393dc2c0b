// SPDX-License-Identifier: Apache-2.0

#include "texgen/raster/distance/pixel_mask.h"

#include "texgen/raster/arcs/arc_crossings.h"
#include "texgen/raster/arcs/pixel_arc.h"
#include "texgen/raster/simd/kernel.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace foam::texgen {

namespace {

// Each arc is oriented upwards, and its crossing with the middle of every row between its ends is
// computed (CrossingSolver). The crossing is rounded to a subpixel: to the nearest one, or up if
// the edges of the outline are straight. All pixels of the row whose middles are at or to the right
// of the rounded crossing are flipped. An arc whose tangent is horizontal somewhere is first split
// into monotone pieces. Rounding depends only on the film, never on the side, so two neighboring
// regions compute the same crossings.

constexpr int kRows = 8;  // number of rows whose crossings are computed at once
using EdgeLanes = ArcLanes::Lanes<double>;
constexpr double kTwoTo52 = 0x1p52;  // its sum with a smaller positive double is a whole number
constexpr double kHalfPixel = 0.5 * kSubpixel;

constexpr std::array<double, kRows> kRowSteps = [] {
    std::array<double, kRows> steps{};
    for (std::size_t k = 0; k < steps.size(); ++k) {
        steps[k] = static_cast<double>(k) * kSubpixel;
    }
    return steps;
}();

// Returns the first column whose middle is at or to the right of x. x is in subpixels.
// Precondition: x is a whole number in [0, 2^31).
[[gnu::always_inline]] inline std::uint64_t first_column_from(double x) {
    return std::bit_cast<std::uint64_t>((x - 0.5) / kSubpixel + kTwoTo52) -
           std::bit_cast<std::uint64_t>(kTwoTo52);
}

// One of these numbers is added to a crossing before it is rounded down. kToNearest rounds to the
// nearest subpixel. kUp rounds up. Rounding up gives the same columns as the exact crossing,
// because the middles of pixels are at whole subpixels. kUp is less than 1, so that a whole number
// is not rounded up to the next one. The crossing of a straight edge that is h subpixels high is a
// multiple of 1/h, so that kUp rounds every other number up if h is at most 2^27 (131,072 pixels).
constexpr double kToNearest = 0.5;
constexpr double kUp = 1.0 - 0x1p-27;

// The words of a mask, its extent, and the rounding of crossings.
struct MaskWords {
    std::uint64_t* words;
    std::size_t stride;        // number of words in a column of words
    std::size_t word_columns;  // number of columns of words
    PixelRows rows;
    int columns;      // number of columns of pixels
    double rounding;  // kToNearest or kUp
};

// Eight arcs that are oriented upwards, in subpixels. Each arc crosses the middles of the rows
// [first, last).
struct alignas(64) RisingArcs {
    // The lower end, then the members of CrossingSolver::Coefficients.
    EdgeLanes low_x, low_y, half_x, half_y, sine, bulge, across, up;
    EdgeLanes first, last;
    EdgeLanes non_monotone_in_y;  // not 0 if the tangent of the arc is horizontal somewhere;
                                  // `first` and `last` are then equal

    [[gnu::always_inline]] CrossingSolver<double> arc(std::size_t k) const {
        return CrossingSolver<double>({half_x[k], half_y[k], sine[k], bulge[k], across[k], up[k]});
    }
};

// Returns the first row whose middle is at or above y, clamped to [rows.begin, rows.end]. y is in
// subpixels.
[[gnu::always_inline]] inline double first_row_from(double y, PixelRows rows) {
    const double row = std::ceil((y - kHalfPixel) / kSubpixel);
    return min_value(max_value(row, static_cast<double>(rows.begin)),
                     static_cast<double>(rows.end));
}

// Moves eight arcs of an outline by (x, y) and orients them upwards. Writes them to `rising`.
// `rows` are the rows of the mask.
[[gnu::always_inline]] inline void orient_upwards(
    const Boundary::Outline& arcs, double x, double y, PixelRows rows, RisingArcs& rising) {
#pragma GCC unroll 1  // GCC would not vectorize the unrolled loop
    for (std::size_t k = 0; k < ArcLanes::kLanes; ++k) {
        const double from_x = arcs.from_x[k];
        const double from_y = arcs.from_y[k];
        const double to_x = arcs.to_x[k];
        const double to_y = arcs.to_y[k];
        const double cosine = arcs.cosine[k];
        const double sine = arcs.sine[k];
        const double dx = to_x - from_x;
        const double dy = to_y - from_y;
        const double up = std::copysign(1.0, dy);
        const double height = std::abs(dy);
        const CrossingSolver<double> arc(up * dx, height, cosine, up * sine);
        const double low_y = min_value(from_y, to_y) + y;
        rising.low_x[k] = 0.5 * (from_x + to_x - up * dx) + x;
        rising.low_y[k] = low_y;
        rising.half_x[k] = arc.coefficients().half_x;
        rising.half_y[k] = arc.coefficients().half_y;
        rising.sine[k] = arc.coefficients().sine;
        rising.bulge[k] = arc.coefficients().bulge;
        rising.across[k] = arc.coefficients().across;
        rising.up[k] = arc.coefficients().up;
        rising.first[k] = first_row_from(low_y, rows);
        const double steepness = cosine * height - std::abs(sine * dx);
        rising.last[k] = first_row_from(low_y + (steepness > 0.0 ? height : 0.0), rows);
        rising.non_monotone_in_y[k] = steepness > 0.0 ? 0.0 : std::abs(dx) + height;
    }
}

// Flips the pixels of a row from the given column to the end of the row.
[[gnu::always_inline]] inline void flip_from(std::uint64_t column, int row, const MaskWords& mask) {
    constexpr std::size_t kColumns = PixelMask::kWordColumns;
    std::uint64_t* const word = mask.words + (row - mask.rows.begin);
    std::size_t k = column / kColumns;
    word[k * mask.stride] ^= ~std::uint64_t{0} << column % kColumns;
    for (++k; k < mask.word_columns; ++k) {
        word[k * mask.stride] ^= ~std::uint64_t{0};
    }
}

// Flips the pixels to the right of an arc in the rows [first, last). (low_x, low_y) is the lower
// end of the arc. If the mask is one word wide, rows are processed in groups of kRows. If the last
// group extends beyond `last`, the words of the rows from `last` on are written back unchanged.
[[gnu::always_inline]] inline void flip_right_of_arc(const CrossingSolver<double>& rising,
                                                     double low_x,
                                                     double low_y,
                                                     int first,
                                                     int last,
                                                     const MaskWords& mask) {
    const CrossingSolver<double> arc = rising;
    const double last_x = mask.columns * kSubpixel;
    const double rounding = mask.rounding;
    const auto column_at = [=](double y) {
        const double x = low_x + std::floor(arc.unbounded_x_at(y) + rounding);
        return first_column_from(min_value(max_value(x, 0.0), last_x));
    };
    if (mask.word_columns > 1) {
        for (int row = first; row < last; ++row) {
            flip_from(column_at(row * kSubpixel + kHalfPixel - low_y), row, mask);
        }
        return;
    }
    const double end = last * kSubpixel + kHalfPixel - low_y;
    int row = first;
    do {  // at least once, because a branch on an empty range would be unpredictable
        const double y = row * kSubpixel + kHalfPixel - low_y;
        std::uint64_t* const word = mask.words + (row - mask.rows.begin);
#pragma GCC unroll 1  // GCC would not vectorize the unrolled loop
        for (std::size_t k = 0; k < kRows; ++k) {
            const double at = y + kRowSteps[k];
            const std::uint64_t crossed = at < end ? ~std::uint64_t{0} : 0;
            word[k] ^= crossed << column_at(at);
        }
        row += kRows;
    } while (row < last);
}

// Flips the pixels to the right of an arc that is not monotone, one monotone piece after the other.
// The pieces are computed from the lower end of the arc, or from its left end if both ends are at
// the same height, so that both sides of a film have the same pieces.
void flip_right_of_pieces(
    const Vec2& from, const Vec2& to, double cosine, double sine, const MaskWords& mask) {
    const Vec2 ahead = to - from;
    const bool is_up = ahead.y() > 0.0 || (ahead.y() == 0.0 && ahead.x() > 0.0);
    const Vec2 tail = is_up ? from : to;
    const PixelArc arc{is_up ? ahead : Vec2(-ahead), cosine, is_up ? sine : -sine};
    const auto inner = [&](const Vec2& at) {
        return Vec2(tail + (at.array() + 0.5).floor().matrix());
    };
    for_each_piece(arc, tail, is_up ? to : from, inner, [&](Vec2 low, Vec2 high, double turn) {
        const bool rises = low.y() < high.y();
        if (!rises) {
            std::swap(low, high);
        }
        const CrossingSolver<double> piece(
            high - low, std::sqrt(1.0 - turn * turn), rises ? turn : -turn);
        at_simd_level([=] {
            flip_right_of_arc(piece,
                              low.x(),
                              low.y(),
                              static_cast<int>(first_row_from(low.y(), mask.rows)),
                              static_cast<int>(first_row_from(high.y(), mask.rows)),
                              mask);
        });
    });
}

}  // namespace

void PixelMask::reset(int columns, PixelRows rows, bool full) {
    columns_ = columns;
    rows_ = rows;
    // The last group of rows may extend beyond the mask by up to kRows rows.
    stride_ = static_cast<std::size_t>(std::max(rows.end - rows.begin, 0)) + kRows;
    const int word_columns = columns / kWordColumns + 1;
    words_.assign(stride_ * static_cast<std::size_t>(word_columns), full ? ~std::uint64_t{0} : 0);
    if (full) {
        std::fill_n(words_.end() - static_cast<std::ptrdiff_t>(stride_),
                    stride_,
                    ~(~std::uint64_t{0} << columns % kWordColumns));
    }
}

void PixelMask::flip_right_of(std::span<const Boundary::Outline> outline,
                              const Vec2& offset,
                              bool is_chain) {
    const MaskWords mask{words_.data(),
                         stride_,
                         words_.size() / stride_,
                         rows_,
                         columns_,
                         is_chain ? kUp : kToNearest};
    non_monotone_.resize(outline.size());
    at_simd_level(
        [outline, mask, x = offset.x(), y = offset.y(), non_monotone = non_monotone_.data()] {
            RisingArcs rising{};
            for (std::size_t block = 0; block < outline.size(); ++block) {
                orient_upwards(outline[block], x, y, mask.rows, rising);
                std::uint32_t bits = 0;
                for (std::size_t k = 0; k < ArcLanes::kLanes; ++k) {
                    bits |= rising.non_monotone_in_y[k] != 0.0 ? 1U << k : 0U;
                    flip_right_of_arc(rising.arc(k),
                                      rising.low_x[k],
                                      rising.low_y[k],
                                      static_cast<int>(rising.first[k]),
                                      static_cast<int>(rising.last[k]),
                                      mask);
                }
                non_monotone[block] = bits;
            }
        });
    for (std::size_t block = 0; block < outline.size(); ++block) {
        const Boundary::Outline& arcs = outline[block];
        for (std::uint32_t bits = non_monotone_[block]; bits != 0; bits &= bits - 1) {
            const auto k = static_cast<std::size_t>(std::countr_zero(bits));
            const Vec2 from(arcs.from_x[k], arcs.from_y[k]);
            const Vec2 to(arcs.to_x[k], arcs.to_y[k]);
            flip_right_of_pieces(from + offset, to + offset, arcs.cosine[k], arcs.sine[k], mask);
        }
    }
}

}  // namespace foam::texgen
