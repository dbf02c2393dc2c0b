#pragma once

#include "texgen/raster/distance/region.h"

#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace foam::texgen {

/// Calls visit(begin, count) for the spans of bits that are set.
template <class Visit>
void for_each_span_of_bits(std::uint64_t bits, const Visit& visit) {
    int end = 0;
    while (bits != 0) {
        const int gap = std::countr_zero(bits);
        const int count = std::countr_one(bits >> gap);
        visit(end + gap, count);
        end += gap + count;
        bits = bits >> gap >> (count - 1) >> 1;  // as a shift by 64 is undefined
    }
}

/// The pixels of a rectangle whose centers are within a region. Two regions that share a side share
/// no pixel along it and leave none out.
///
/// A mask starts empty, or full for a region without an end. Each side of the boundary then flips
/// all pixels to the right of it, row by row (even-odd rule). A center on a side is to its right.
class PixelMask {
  public:
    static constexpr int kWordColumns = 64;

    /// Starts a mask of some rows of a box; columns and rows count from the box's lower left
    /// corner.
    void reset(int columns, PixelRows rows, bool full = false);

    int columns() const { return columns_; }
    PixelRows rows() const { return rows_; }

    /// Flips the pixels to the right of each arc of an outline, which is moved by whole subpixels
    /// to be relative to the corner of the box. Crossings are rounded to subpixels, but not those
    /// of a chain.
    void flip_right_of(std::span<const Boundary::Outline> outline,
                       const Vec2& offset,
                       bool is_chain);

    /// Returns 64 pixels of a row from column 64 k on, the first one in the lowest bit.
    std::uint64_t word(int k, int row) const {
        return words_[static_cast<std::size_t>(k) * stride_ +
                      static_cast<std::size_t>(row - rows_.begin)];
    }

    /// Calls visit(column, count) for the spans of a row, each within one word.
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
    std::size_t stride_ = 0;             // words from a column of words to the next one
    std::vector<std::uint64_t> words_;   // of all rows, one column of words after the other
    std::vector<std::uint32_t> others_;  // arcs of an outline that go up and down
};

}  // namespace foam::texgen
