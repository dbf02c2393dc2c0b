// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/raster/distance/region.h"

#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace foam::texgen {

/// Calls visit(begin, count) for each span of bits that are set, from the lowest bit on.
template <class Visit>
void for_each_span_of_bits(std::uint64_t bits, const Visit& visit) {
    int end = 0;
    while (bits != 0) {
        const int gap = std::countr_zero(bits);
        const int count = std::countr_one(bits >> gap);
        visit(end + gap, count);
        end += gap + count;
        bits = bits >> gap >> (count - 1) >> 1;  // three shifts, because a shift by 64 is undefined
    }
}

/// The pixels of a rectangle whose centers are within a region, as a bit mask. Of two regions that
/// share a side, exactly one contains each pixel along that side.
///
/// The region is filled by the even-odd rule: a mask starts empty, or full for an unbounded region,
/// and each arc of the boundary flips all pixels to the right of it, row by row. A center exactly
/// on an arc counts as to the right of it.
class PixelMask {
  public:
    static constexpr int kWordColumns = 64;

    /// Starts a mask of some rows of a box. Columns and rows count from the lower left corner of
    /// the box. `full` is true for an unbounded region.
    void reset(int columns, PixelRows rows, bool full = false);

    int columns() const { return columns_; }
    PixelRows rows() const { return rows_; }

    /// Flips the pixels to the right of each arc of an outline. `offset` is the translation from
    /// the outline to the corner of the box, in whole subpixels. Crossings with rows are rounded to
    /// the nearest subpixel. If `is_chain` is true, the outline has straight edges, whose crossings
    /// are exact.
    void flip_right_of(std::span<const Boundary::Outline> outline,
                       const Vec2& offset,
                       bool is_chain);

    /// Returns the 64 pixels of a row from column 64 k on, the first pixel in the lowest bit.
    std::uint64_t word(int k, int row) const {
        return words_[static_cast<std::size_t>(k) * stride_ +
                      static_cast<std::size_t>(row - rows_.begin)];
    }

    /// Calls visit(column, count) for the spans of set pixels in a row. Spans end at the borders of
    /// words.
    template <class Visit>
    void for_each_span(int row, const Visit& visit) const {
        for (int k = 0; k * kWordColumns < columns_; ++k) {
            for_each_span_of_bits(word(k, row), [&](int begin, int count) {
                visit(k * kWordColumns + begin, count);
            });
        }
    }

  private:
    int columns_ = 0;
    PixelRows rows_;
    std::size_t stride_ = 0;                   // distance between columns of words, in words
    std::vector<std::uint64_t> words_;         // all rows, one column of words after the other
    std::vector<std::uint32_t> non_monotone_;  // per block of an outline: bits of arcs that are not
                                               // monotone in y
};

}  // namespace foam::texgen
