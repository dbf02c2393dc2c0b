// SPDX-License-Identifier: Apache-2.0

#include "texgen/raster/distance/pixel_mask.h"

#include "core/parallel/kernel_array.h"
#include "texgen/raster/arcs/arc_crossings.h"
#include "texgen/raster/simd/kernel.h"

#include <boost/container/small_vector.hpp>

#include <algorithm>
#include <bit>
#include <cmath>

// The method is the edge fill algorithm (D. F. Rogers, "Procedural Elements for Computer Graphics",
// 1985). Edges need not be sorted, because flips commute. The bits of 64 pixels of a row are one
// word, so that an arc flips them by one operation. The words of successive rows are contiguous, so
// that one vector instruction flips words of several rows. Two properties are our own: edges may be
// arcs, and the crossings computed from the two sides of a film are equal.

namespace foam::texgen {

namespace {

constexpr int kRows = 8;             // number of rows whose crossings are computed at once
constexpr double kTwoTo52 = 0x1p52;  // its sum with a smaller positive double is a whole number
constexpr double kHalfPixel = 0.5 * kSubpixel;
// The heights of kRows successive rows above the first of them, in subpixels. They are stored as
// doubles. If the loop converted row numbers to doubles instead, GCC would use only half of each
// 512-bit register.
constexpr auto kHeights = [] {
    KernelArray<double, kRows> heights;
    for (int k = 0; k < kRows; ++k) {
        heights[static_cast<std::size_t>(k)] = k * kSubpixel;
    }
    return heights;
}();

// Returns the first column whose middle is at or to the right of x. x is in subpixels.
// Precondition: x is a whole number in [0, 2^31).
[[gnu::always_inline]] inline std::uint64_t first_column_from(double x) {
    return std::bit_cast<std::uint64_t>((x - 0.5) / kSubpixel + kTwoTo52) -
           std::bit_cast<std::uint64_t>(kTwoTo52);
}

// A crossing is the x coordinate, in subpixels, at which an arc crosses the middle of a row. To
// round a crossing, one of these numbers is added to it, and the sum is rounded down. Adding
// kToNearest rounds to the nearest subpixel. Adding kUp rounds up; a crossing at a whole number is
// not changed. The middles of pixels are at whole subpixels, so a crossing that is rounded up gives
// the same columns as the exact crossing. The crossing of a straight edge that is h subpixels high
// is a multiple of 1/h, so that kUp is large enough for h up to 2^27.
constexpr double kToNearest = 0.5;
constexpr double kUp = 1.0 - 0x1p-27;

// Returns the first row whose middle is at or above y, clamped to [rows.begin, rows.end]. y is in
// subpixels.
[[gnu::always_inline]] inline int first_row_from(double y, PixelRows rows) {
    const double row = std::ceil((y - kHalfPixel) / kSubpixel);
    return static_cast<int>(
        min_value(max_value(row, static_cast<double>(rows.begin)), static_cast<double>(rows.end)));
}

// A rising arc, in subpixels, that is monotone in y.
struct RisingArc {
    Vec2 low;
    Vec2 high;
    CrossingSolver<double> crossings;
};

// Calls visit(RisingArc) for the parts of an arc that are monotone in y, oriented upwards. `offset`
// is added to all positions. The parts are computed from the lower end of the arc, or from its left
// end if both ends are at the same height. Both sides of a film therefore have the same parts.
template <class Visit>
void for_each_rising_part(const OutlineArc& arc, const Vec2& offset, const Visit& visit) {
    const Vec2 ahead = arc.to - arc.from;
    const bool is_up = ahead.y() > 0.0 || (ahead.y() == 0.0 && ahead.x() > 0.0);
    const Vec2 tail = (is_up ? arc.from : arc.to) + offset;
    const PixelArc shape{is_up ? ahead : Vec2(-ahead), arc.cosine, is_up ? arc.sine : -arc.sine};
    const Vec2 head = tail + shape.chord;
    if (shape.cosine * shape.chord.y() > std::abs(shape.sine * shape.chord.x())) [[likely]] {
        visit({tail, head, CrossingSolver<double>(shape.chord, shape.cosine, shape.sine)});
        return;
    }
    if (ahead.isZero(0.0)) {
        return;
    }
    const auto inner = [&](const Vec2& at) {
        return Vec2(tail + (at.array() + 0.5).floor().matrix());
    };
    for_each_piece(shape, tail, head, inner, [&](const Vec2& from, const Vec2& to, double sine) {
        if (from.y() < to.y()) {
            visit({from, to, CrossingSolver<double>(to - from, sine)});
        } else {
            visit({to, from, CrossingSolver<double>(from - to, -sine)});
        }
    });
}

}  // namespace

void PixelMask::reset(int columns, PixelRows rows, bool full) {
    columns_ = columns;
    rows_ = rows;
    // The last group of rows may extend beyond the mask by less than kRows rows.
    stride_ = static_cast<std::size_t>(std::max(rows.end - rows.begin, 0)) + kRows;
    const int word_columns = columns / kWordColumns + 1;
    words_.assign(stride_ * static_cast<std::size_t>(word_columns), full ? ~std::uint64_t{0} : 0);
    if (full) {
        std::fill_n(words_.end() - static_cast<std::ptrdiff_t>(stride_),
                    stride_,
                    ~(~std::uint64_t{0} << columns % kWordColumns));
    }
}

// Computes the crossings with the middles of rows in groups of kRows. If the last group of rows
// extends beyond the arc, the words of the rows beyond the arc are written back unchanged. Rounding
// depends only on the film and on `is_chain`, which is the same for all regions of a frame. Two
// neighboring regions therefore compute the same crossings.
// NOLINTNEXTLINE(readability-function-size): a vectorized kernel keeps its loops in one function
void PixelMask::flip_right_of(std::span<const OutlineArc> outline,
                              const Vec2& offset,
                              bool is_chain) {
    boost::container::small_vector<RisingArc, 16> rising;
    for (const OutlineArc& arc : outline) {
        for_each_rising_part(arc, offset, [&](const RisingArc& part) { rising.push_back(part); });
    }
    at_simd_level([arcs = std::span<const RisingArc>(rising.data(), rising.size()),
                   rounding = is_chain ? kUp : kToNearest,
                   rows = rows_,
                   last_x = static_cast<double>(columns_) * kSubpixel,
                   words = words_.data(),
                   stride = stride_,
                   end = words_.data() + words_.size()] {
        for (const RisingArc& arc : arcs) {
            const CrossingSolver<double> crossings = arc.crossings;
            const double low_x = arc.low.x();
            const double low_y = arc.low.y();
            const int last = first_row_from(arc.high.y(), rows);
            const double beyond = last * kSubpixel + kHalfPixel - low_y;
            for (int row = first_row_from(low_y, rows); row < last; row += kRows) {
                const double y = row * kSubpixel + kHalfPixel - low_y;
                KernelArray<std::uint64_t, kRows> columns;
                KernelArray<std::uint64_t, kRows> crossed;
#pragma GCC unroll 1  // GCC would not vectorize the unrolled loop
                for (std::size_t k = 0; k < kRows; ++k) {
                    const double at = y + kHeights[k];
                    const double x = low_x + std::floor(crossings.unbounded_x_at(at) + rounding);
                    columns[k] = first_column_from(min_value(max_value(x, 0.0), last_x));
                    crossed[k] = at < beyond ? ~std::uint64_t{0} : 0;
                }
                std::uint64_t* word = words + (row - rows.begin);
                for (std::uint64_t left = 0; word < end; left += kWordColumns, word += stride) {
#pragma GCC unroll 1
                    for (std::size_t k = 0; k < kRows; ++k) {
                        // A shift by 64 or more is undefined.
                        const std::uint64_t in_word = max_value(columns[k], left) - left;
                        word[k] ^= in_word < 64 ? crossed[k] << in_word % 64 : 0;
                    }
                }
            }
        }
    });
}

}  // namespace foam::texgen
