// SPDX-License-Identifier: Apache-2.0

#include "texgen/raster/coverage/coverage.h"

#include "texgen/raster/coords/raster_grid.h"
#include "texgen/raster/simd/kernel.h"

#include <algorithm>
#include <bit>
#include <limits>
#include <utility>

namespace foam::texgen {

namespace {

static_assert(kLargestGridSide <= std::numeric_limits<std::uint16_t>::max(),
              "elements of RowSums::begins have 16 bits");

constexpr std::size_t kFlagsPerWord = 64;

// Adds factor * values to sums, per channel. Reads all channels before it writes any, so that the
// loop is vectorized.
template <class Sums>
void add_times(double factor, const Sums& values, Sums& to) {
    Sums sums = to;
    for (std::size_t c = 0; c < sums.size(); ++c) {
        sums[c] += factor * values[c];
    }
    to = sums;
}

constexpr std::size_t kFlagsPerStep = 4;

// Stores the first position, each position with a flag and the position after it, in increasing
// order, clears the flags, and returns the number of positions. Stores kFlagsPerStep positions at a
// time, and overwrites up to kFlagsPerStep - 1 elements after the last position. The end of a loop
// over single flags would often be mispredicted.
[[gnu::always_inline]] inline std::size_t take_begins(std::span<std::uint64_t> flags,
                                                      std::uint16_t* positions) {
    std::size_t count = 0;
    std::uint64_t carry = 1;  // the lowest bit of the next word
    for (std::size_t word = 0; word < flags.size(); ++word) {
        std::uint64_t bits = flags[word] | flags[word] << 1 | carry;
        carry = flags[word] >> (kFlagsPerWord - 1);
        flags[word] = 0;
        const std::size_t end = count + static_cast<std::size_t>(std::popcount(bits));
        for (; count < end; count += kFlagsPerStep) {
            for (std::size_t k = 0; k < kFlagsPerStep; ++k) {
                const auto bit = static_cast<std::size_t>(std::countr_zero(bits));
                positions[count + k] = static_cast<std::uint16_t>(word * kFlagsPerWord + bit);
                bits &= bits - 1;
            }
        }
        count = end;
    }
    return count;
}

}  // namespace

template <std::size_t Channels>
Coverage<Channels>::Coverage(int width, int rows, RowKind kind)
    : width_(width),
      kind_(kind),
      splitter_(rows),
      rows_(static_cast<std::size_t>(rows)),
      cells_(static_cast<std::size_t>(width) + 1),
      touched_(static_cast<std::size_t>(width) / kFlagsPerWord + 1) {}

template <std::size_t Channels>
void Coverage<Channels>::clear() {
    splitter_.clear();
    across_.clear();
    for (Row& row : rows_) {
        row.parts.clear();
        row.start = {};
    }
}

template <std::size_t Channels>
void Coverage<Channels>::add(const MonotoneArc& arc, SubpixelPoint translation, const Step& step) {
    if (!splitter_.is_in_rows(arc, translation)) {
        return;
    }
    steps_[splitter_.size()] = step;
    splitter_.add(arc, translation);
    if (splitter_.size() == ArcSplitter::kMaxArcs) {
        finish();
    }
}

template <std::size_t Channels>
void Coverage<Channels>::finish() {
    splitter_.split();
    for (std::size_t k = 0; k < splitter_.size(); ++k) {
        add_parts(k);
        if (steps_[k].wraps) [[unlikely]] {
            for (const ArcSplitter::Part& part : splitter_.parts(k)) {
                Sums& start = rows_[static_cast<std::size_t>(part.row)].start;
                add_times(-part.twice_area, steps_[k].period_correction, start);
            }
        }
    }
    splitter_.clear();
}

// Stores the parts of a pending arc in their rows.
template <std::size_t Channels>
void Coverage<Channels>::add_parts(std::size_t k) {
    const auto arc = static_cast<std::uint32_t>(across_.size());
    across_.push_back(steps_[k].across);
    const bool is_inside = splitter_.leftmost(k) >= 0 && splitter_.rightmost(k) < width_;
    for (const ArcSplitter::Part& part : splitter_.parts(k)) {
        Row& row = rows_[static_cast<std::size_t>(part.row)];
        if (is_inside) [[likely]] {
            row.parts.push_back({part.column, part.twice_area, part.twice_area_on_left, arc});
        } else {
            add_outside(part, arc, row);
        }
    }
}

// Stores a part of an arc that is not entirely within the columns. The class comment tells what
// parts to the left and to the right of the columns add.
template <std::size_t Channels>
void Coverage<Channels>::add_outside(const ArcSplitter::Part& part, std::uint32_t arc, Row& row) {
    const std::int32_t periods = floor_div(part.column, width_);
    const bool is_ring = kind_ == RowKind::Ring;
    const std::int32_t times = is_ring ? -periods : periods < 0 ? 1 : 0;
    add_times(static_cast<double>(times) * part.twice_area, across_[arc], row.start);
    if (is_ring || periods == 0) {
        row.parts.push_back(
            {part.column - periods * width_, part.twice_area, part.twice_area_on_left, arc});
    }
}

// Spans begin at the pixels that contain parts, at the pixels after them, and at the first pixel.
// If the last pixel contains a part, the span that begins after it is dropped.
template <std::size_t Channels>
void Coverage<Channels>::take_row(int row, const Sums& start, RowSums<Channels>& sums) {
    const auto width = static_cast<std::size_t>(width_);
    Row& own = rows_[static_cast<std::size_t>(row)];
    grow(sums.begins, width + 2 + kFlagsPerStep);
    grow(sums.sums, width + 2);
    Sums first = start;
    add_times(1, std::exchange(own.start, Sums{}), first);
    sums.count = at_simd_level([parts = std::span<const RowPart>(own.parts),
                                across = across_.data(),
                                touched = std::span<std::uint64_t>(touched_),
                                first,
                                cells = cells_.data(),
                                begins = sums.begins.data(),
                                to = sums.sums.data()] {
        for (const RowPart& part : parts) {
            const auto column = static_cast<std::size_t>(part.column);
            touched[column / kFlagsPerWord] |= std::uint64_t{1} << column % kFlagsPerWord;
            const Sums step = across[part.arc];
            add_times(part.twice_area, step, cells[column].all);
            add_times(part.twice_area_on_left, step, cells[column].left);
        }
        const std::size_t count = take_begins(touched, begins);
        Sums running = first;
        for (std::size_t k = 0; k < count; ++k) {
            Cell& cell = cells[begins[k]];
            add_times(1, cell.all, running);
            Sums sum = running;
            add_times(-1, cell.left, sum);
            to[k] = sum;
            cell = {};
        }
        return count;
    });
    own.parts.clear();
    if (sums.begins[sums.count - 1] == width) {
        --sums.count;
    }
    sums.begins[sums.count] = static_cast<std::uint16_t>(width);
}

template class Coverage<1>;
template class Coverage<2>;
template class Coverage<3>;
template class Coverage<4>;

}  // namespace foam::texgen
