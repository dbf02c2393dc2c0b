#pragma once

#include "texgen/raster/coords/fixed_point.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace foam::texgen {

/// Which pixels of a rectangle have their centre within a chain; a centre on an edge is on its
/// right. Two chains that share an edge share no pixel along it and leave none out.
class CellMask {
  public:
    /// An empty mask. Rows and columns in pixels; the first `unused_rows` stay empty.
    void reset(int columns, int rows, int unused_rows = 0);

    int columns() const { return columns_; }
    int rows() const { return rows_; }

    /// The pixels within a closed chain, which is relative to the mask's lower left corner. What of
    /// it lies outside of the mask is left out. Precondition: the mask is empty.
    void fill(std::span<const SubpixelPoint> chain, SubpixelPoint translation);

    /// Marks where a boundary crosses the middle of a row, x in subpixels: all pixels from there on
    /// change sides. Until `close` the mask holds these marks.
    void cross(int row, std::int32_t x) {
        const int column = std::clamp(first_middle_from(x), 0, columns_);
        word(column, row) ^= bit(column);
    }
    /// Makes pixels of the marks.
    void close();

    /// The rows whose middle lies in [low, high), of those that are used.
    struct Rows {
        int begin;
        int end;
    };
    Rows rows_between(std::int32_t low, std::int32_t high) const {
        return {std::max(first_middle_from(low), unused_rows_),
                std::min(first_middle_from(high), rows_)};
    }

    /// Adds one pixel.
    void set(int column, int row) { word(column, row) |= bit(column); }

    /// 16 pixels from column 16 k on, the first in the lowest bit.
    std::uint16_t sixteen(int k, int row) const {
        return static_cast<std::uint16_t>(
            words_[row_begin(row) + static_cast<std::size_t>(k / 4)] >> (16 * (k % 4)));
    }

    /// All pixels of a row, of a mask of up to 64 columns; the first in the lowest bit.
    std::uint64_t whole_row(int row) const { return words_[row_begin(row)]; }

    /// Calls visit(begin, end) for the runs of columns in a row.
    template <class Visit>
    void for_each_run(int row, const Visit& visit) const {
        int column = (sixteen(0, row) & 1) != 0 ? 0 : next_change(row, 0);
        while (column < columns_) {
            const int end = next_change(row, column);
            visit(column, end);
            column = next_change(row, end);
        }
    }

  private:
    static constexpr int kBits = 64;

    std::size_t row_begin(int row) const { return static_cast<std::size_t>(row) * stride_; }
    std::uint64_t& word(int column, int row) {
        return words_[row_begin(row) + static_cast<std::size_t>(column / kBits)];
    }
    static std::uint64_t bit(int column) { return std::uint64_t{1} << (column % kBits); }
    int next_change(int row, int column) const;
    void toggle(SubpixelPoint low, SubpixelPoint high, int begin, int end);

    int columns_ = 0;
    int rows_ = 0;
    int unused_rows_ = 0;
    std::size_t stride_ = 0;  // words
    std::vector<std::uint64_t> words_;
};

}  // namespace foam::texgen
