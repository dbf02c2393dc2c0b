#include "texgen/raster/cell_mask.h"

#include <algorithm>
#include <bit>

namespace foam::texgen {

namespace {

// Of which bit k says whether an odd number of the bits up to k are set.
std::uint64_t parities(std::uint64_t bits) {
    for (int shift = 1; shift < 64; shift *= 2) {
        bits ^= bits << shift;
    }
    return bits;
}

}  // namespace

void CellMask::reset(int columns, int rows, int unused_rows) {
    columns_ = std::max(columns, 0);
    rows_ = std::max(rows, 0);
    unused_rows_ = unused_rows;
    stride_ = static_cast<std::size_t>(columns_ / kBits) + 1;  // one bit more for what is beyond
    words_.assign(stride_ * static_cast<std::size_t>(rows_), 0);
}

void CellMask::fill(std::span<const SubpixelPoint> chain, SubpixelPoint translation) {
    SubpixelPoint from = chain.back() + translation;
    int from_row = first_middle_from(from.y);
    for (const SubpixelPoint point : chain) {
        const SubpixelPoint to = point + translation;
        const int to_row = first_middle_from(to.y);
        if (from_row < to_row) {
            toggle(from, to, from_row, to_row);
        } else if (to_row < from_row) {
            toggle(to, from, to_row, from_row);
        }
        from = to;
        from_row = to_row;
    }
    close();
}

void CellMask::close() {
    for (int row = unused_rows_; row < rows_; ++row) {
        bool odd = false;
        for (std::size_t k = row_begin(row); k < row_begin(row + 1); ++k) {
            words_[k] = parities(words_[k]) ^ (odd ? ~std::uint64_t{0} : 0);
            odd = (words_[k] >> (kBits - 1)) != 0;
        }
    }
}

// Where an edge crosses the middles of rows. The quotient of integers below 2^53 is never rounded
// across a whole number.
void CellMask::toggle(SubpixelPoint low, SubpixelPoint high, int begin, int end) {
    const double across = high.x - low.x;
    const double up = high.y - low.y;
    for (int row = std::max(begin, unused_rows_); row < std::min(end, rows_); ++row) {
        const std::int32_t y = row * kSubpixel + kSubpixel / 2 - low.y;
        const double x = across * y / up;
        const auto toward_zero = static_cast<std::int32_t>(x);
        const std::int32_t next = low.x + toward_zero + (x > toward_zero ? 1 : 0);
        cross(row, next);
    }
}

// The end of the run of equal pixels that holds the column; no more than columns().
int CellMask::next_change(int row, int column) const {
    if (column >= columns_) {
        return columns_;
    }
    std::size_t k = row_begin(row) + static_cast<std::size_t>(column / kBits);
    const std::uint64_t same = (words_[k] & bit(column)) != 0 ? ~std::uint64_t{0} : 0;
    std::uint64_t others = (words_[k] ^ same) & ~(bit(column) - 1);
    int begin = column / kBits * kBits;
    while (others == 0 && begin + kBits < columns_) {
        others = words_[++k] ^ same;
        begin += kBits;
    }
    return others == 0 ? columns_ : std::min(columns_, begin + std::countr_zero(others));
}

}  // namespace foam::texgen
