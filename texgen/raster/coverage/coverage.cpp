// SPDX-License-Identifier: Apache-2.0

#include "texgen/raster/coverage/coverage.h"

#include "texgen/image/cache_line.h"
#include "texgen/raster/coords/raster_grid.h"
#include "texgen/raster/simd/kernel.h"

#include <algorithm>
#include <bit>
#include <limits>
#include <utility>

namespace foam::texgen {

namespace {

static_assert(kLargestSide <= std::numeric_limits<std::uint16_t>::max(),
              "elements of RowSums::begins have 16 bits");

constexpr std::size_t kFlagsPerWord = 64;

// Returns the distance between the starts of successive rows, in pixels: an odd number of cache
// lines, because the rows of an arc would compete for few cache sets if it were a power of two.
std::size_t stride_of(int width, std::size_t sum_bytes) {
    constexpr std::size_t kLinesModulo8 = 5;  // cache lines per row, modulo 8; must be odd
    const std::size_t per_line = kLineBytes / sum_bytes;
    std::size_t lines = static_cast<std::size_t>(width) / per_line + 1;
    while (lines % 8 != kLinesModulo8) {
        ++lines;
    }
    return lines * per_line;
}

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

// Stores the positions of the flags that are set, in increasing order, and returns their number.
// Stores kFlagsPerStep positions at a time, and overwrites up to kFlagsPerStep - 1 elements after
// the last position. The end of a loop over single flags would often be mispredicted.
[[gnu::always_inline]] inline std::size_t find_flags(std::span<const std::uint64_t> flags,
                                                     std::uint16_t* positions) {
    std::size_t count = 0;
    for (std::size_t word = 0; word < flags.size(); ++word) {
        std::uint64_t bits = flags[word];
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

// Pointers to the arrays of a band, and the lengths of their rows.
template <std::size_t Channels>
struct Coverage<Channels>::Band {
    Sums* differences;
    std::size_t stride;
    std::uint64_t* touched;
    std::size_t words;

    // Adds the areas beside a part, times the change of values across its arc, to the differences
    // of two pixels: the area on its right to the pixel of the part, and the area on its left to
    // the next pixel, so that the running sum adds their sum to all pixels further right.
    void add(std::size_t row,
             std::size_t column,
             const ArcSplitter::Part& part,
             const Sums& across) const {
        touch(&touched[row * words + column / kFlagsPerWord], column % kFlagsPerWord);
        Sums* to = &differences[row * stride + column];
        add_times(part.twice_area - part.twice_area_on_left, across, to[0]);
        add_times(part.twice_area_on_left, across, to[1]);
    }

    // Sets the flags of a pixel and of the pixel on its right.
    static void touch(std::uint64_t* flags, std::size_t bit) {
        flags[0] |= std::uint64_t{3} << bit;
        if (bit + 1 == kFlagsPerWord) [[unlikely]] {
            flags[1] |= 1;
        }
    }
};

template <std::size_t Channels>
Coverage<Channels>::Coverage(int width, int rows, RowKind kind)
    : width_(width),
      kind_(kind),
      stride_(stride_of(width, sizeof(Sums))),
      words_(static_cast<std::size_t>(width) / kFlagsPerWord + 1),
      differences_(stride_ * static_cast<std::size_t>(rows)),
      touched_(words_ * static_cast<std::size_t>(rows)),
      splitter_(rows),
      starts_(static_cast<std::size_t>(rows)) {}

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
        if (is_inside(k)) [[likely]] {
            add_inside(splitter_.parts(k), steps_[k]);
        } else {
            add_outside(splitter_.parts(k), steps_[k]);
        }
        if (steps_[k].wraps) [[unlikely]] {
            for (const ArcSplitter::Part& part : splitter_.parts(k)) {
                Sums& start = starts_[static_cast<std::size_t>(part.row)];
                add_times(-part.twice_area, steps_[k].period_correction, start);
            }
        }
    }
    splitter_.clear();
}

template <std::size_t Channels>
void Coverage<Channels>::add_inside(Parts parts, const Step& step) {
    const Band band{differences_.data(), stride_, touched_.data(), words_};
    // With a copy of `across`, compilers merge the two sums of a part into one wide store, on which
    // the next load would stall if it overlaps only half of it.
    at_simd_level([parts, &across = step.across, band] {
        for (const ArcSplitter::Part& part : parts) {
            band.add(static_cast<std::size_t>(part.row),
                     static_cast<std::size_t>(part.column),
                     part,
                     across);
        }
    });
}

// Adds an arc that has parts to the left or to the right of the columns of the band, and wraps them
// around on a ring.
template <std::size_t Channels>
void Coverage<Channels>::add_outside(Parts parts, const Step& step) {
    const Band band{differences_.data(), stride_, touched_.data(), words_};
    for (const ArcSplitter::Part& part : parts) {
        const auto row = static_cast<std::size_t>(part.row);
        const std::int32_t periods = floor_div(part.column, width_);
        const bool is_ring = kind_ == RowKind::Ring;
        const std::int32_t times = is_ring ? -periods : periods < 0 ? 1 : 0;
        add_times(static_cast<double>(times) * part.twice_area, step.across, starts_[row]);
        if (is_ring || periods == 0) {
            band.add(
                row, static_cast<std::size_t>(part.column - periods * width_), part, step.across);
        }
    }
}

// A span begins at each pixel with a flag. The pixel after the last one may have a flag, too.
template <std::size_t Channels>
void Coverage<Channels>::take_row(int row, const Sums& start, RowSums<Channels>& sums) {
    const auto index = static_cast<std::size_t>(row);
    const auto width = static_cast<std::size_t>(width_);
    const std::span<std::uint64_t> touched(&touched_[index * words_], words_);
    grow(sums.begins, width + 2 + kFlagsPerStep);
    grow(sums.sums, width + 2);
    Sums first = start;
    add_times(1, std::exchange(starts_[index], Sums{}), first);
    // There is a span before the first flag unless the first pixel has a flag.
    const std::size_t leading_spans = (touched[0] & 1) == 0 ? 1 : 0;
    sums.begins[0] = 0;
    sums.sums[0] = first;
    sums.count = at_simd_level([touched,
                                leading_spans,
                                first,
                                differences = &differences_[index * stride_],
                                begins = sums.begins.data(),
                                to = sums.sums.data()] {
        const std::size_t count = leading_spans + find_flags(touched, &begins[leading_spans]);
        Sums running = first;
        for (std::size_t k = leading_spans; k < count; ++k) {
            add_times(1, std::exchange(differences[begins[k]], Sums{}), running);
            to[k] = running;
        }
        return count;
    });
    std::fill(touched.begin(), touched.end(), 0);
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
