// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/raster/distance/region.h"

#include <bit>
#include <cstdint>
#include <span>
#include <vector>

namespace foam::texgen {

/// Calls visit(begin, count) for each span of successive bits that are set, starting with the
/// lowest. `begin` is the index of the lowest bit of the span.
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

/// A bit mask of a rectangle of pixels. The bit of a pixel is set if the center of the pixel is
/// within a region. The mask is filled by the even-odd rule. The mask starts empty, or full for an
/// unbounded region. Each arc of the boundary then flips all pixels to the right of the arc, row by
/// row. A center on an arc counts as being to the right of the arc. Each pixel along the common
/// side of two regions is therefore in exactly one of the two.
class PixelMask {
  public:
    static constexpr int kWordColumns = 64;

    /// Starts a mask of the given rows of a box with `columns` columns. Rows and columns count from
    /// the lower left corner of the box. The mask is full if `full` is true, for an unbounded
    /// region; otherwise it is empty.
    void reset(int columns, PixelRows rows, bool full = false);

    int columns() const { return columns_; }
    PixelRows rows() const { return rows_; }

    /// Flips the pixels to the right of each arc of an outline. `offset` is the translation from
    /// the coordinates of the outline to those of the box, in subpixels; its components are whole
    /// numbers. The point at which an arc crosses the middle of a row is rounded to the nearest
    /// subpixel. If `is_chain` is true, all edges of the outline must be straight, and the exact
    /// crossings are used instead.
    void flip_right_of(std::span<const OutlineArc> outline, const Vec2& offset, bool is_chain);

    /// Returns the 64 pixels of a row from column 64 k on. The lowest bit is the leftmost pixel.
    std::uint64_t word(int k, int row) const {
        return words_[static_cast<std::size_t>(k) * stride_ +
                      static_cast<std::size_t>(row - rows_.begin)];
    }

    /// Calls visit(column, count) for each span of set pixels in a row. A span ends where a word
    /// ends, even if the next pixel is set.
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
    std::size_t stride_ = 0;            // number of words in a column of words
    std::vector<std::uint64_t> words_;  // one column of words after the other, a word per row
};

}  // namespace foam::texgen
