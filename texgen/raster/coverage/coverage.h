// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/parallel/kernel_array.h"
#include "texgen/raster/coords/fixed_point.h"
#include "texgen/raster/coords/raster_grid.h"
#include "texgen/raster/coverage/arc_splitter.h"
#include "texgen/raster/simd/kernel.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <cstring>
#include <limits>
#include <span>
#include <type_traits>
#include <utility>
#include <vector>

namespace foam::texgen {

/// The binary logarithm of the area of a pixel. The unit of areas is half a square subpixel.
inline constexpr int kAreaBits = 2 * kSubpixelBits + 1;

static_assert(kMaxGridSide <= std::numeric_limits<std::uint16_t>::max(),
              "Coverage stores columns in 16 bits");

/// The largest possible mean of 16-bit values.
inline constexpr std::int32_t kMaxMean = std::numeric_limits<std::uint16_t>::max();

/// The area of a pixel.
inline constexpr double kPixelArea = 1 << kAreaBits;

/// The sums of a pixel, one per channel: 16-bit values times areas. A double represents them
/// exactly, because they are integers below 2^53. The number of channels is rounded up to a power
/// of two, so that loops over channels are vectorized; unused channels are 0.
template <std::size_t Channels>
using PixelSums = std::array<double, std::bit_ceil(Channels)>;

/// Returns the mean value of a pixel, sum / kPixelArea, rounded to the nearest integer. The result
/// is clamped to the range of values, because the mean may be outside of this range where rafts, or
/// parts of one raft, overlap, or where the foam is invalid.
inline std::uint16_t mean_of(double sum) {
    constexpr double kHalf = 0.5;  // makes the truncation round to the nearest
    const auto mean = static_cast<std::int32_t>(sum * (1.0 / kPixelArea) + kHalf);
    return static_cast<std::uint16_t>(std::min(std::max(mean, 0), kMaxMean));
}

/// The topology of a row of pixels: a ring around a torus, or a line segment in the plane.
enum class RowKind { Ring, Line };

/// Computes sums of values times areas in a band of rows. Each arc is added with the change of the
/// values from its left to its right, per channel. The sum of a pixel is a start value plus the
/// contributions of all arcs. All of these are integers, so that the sum does not depend on the
/// order of the arcs.
///
/// In each row, an arc adds its change of values times the area on its right. In the pixel of a
/// part of the arc (ArcSplitter::Part), this is the area between the part and the right border of
/// the pixel. In each pixel further right, this area is the height of the part times the width of a
/// pixel. The full contribution of a part is its contribution to each pixel further right: height
/// times pixel width times change of values.
///
/// The band stores the parts of each row in a list. When the row is taken (take_row), its parts are
/// added to cells, one per pixel. A cell is the difference between the sum of its pixel and the sum
/// of the pixel before it. To the cell of its own pixel, a part adds its contribution to this
/// pixel; to the next cell, it adds the rest of the full contribution. A running sum along the row
/// converts cells to sums of pixels.
///
/// On a torus, an arc outside of the image is added at its wrapped column. The sums would be right
/// if all arcs of an outline were in the same period, because their signed heights then cancel in
/// every row. If an arc is k periods to the right of the image, every pixel of its rows gets k
/// times the full contribution too much. This amount is subtracted at the start of each of these
/// rows. In the plane, an arc to the left of the image adds its full contribution to all pixels of
/// its rows. An arc to the right adds nothing.
template <std::size_t Channels>
class Coverage {
  public:
    using Sums = PixelSums<Channels>;

    /// The change of values from the left of an arc to its right.
    struct Step {
        Sums across{};  // value on the right minus value on the left
        // The correction for an arc that is some periods further right in the unwrapped outline of
        // one of its bubbles than in the image (ArcSides). It is the value on the right times
        // right_periods, minus the value on the left times left_periods. Each part of the arc
        // subtracts the correction, times ArcSplitter::Part::twice_area, from the start of its row.
        Sums period_correction{};
        bool wraps = false;  // if false, `period_correction` is 0
    };

    /// Creates a band of `rows` rows and `width` columns without arcs.
    Coverage(int width, int rows, RowKind kind = RowKind::Ring);

    /// Removes all arcs, so that the memory is reused for another band.
    void clear();

    /// Adds an arc, moved by a translation. After the translation, y is relative to the lower
    /// border of the band. Parts above and below the band are ignored. Arcs are split in batches,
    /// so the last arcs are pending until finish() is called.
    void add(const MonotoneArc& arc, SubpixelPoint translation, const Step& step);

    /// Adds all pending arcs.
    void finish();

    /// Calls visit(begin, end, sums) for the spans of pixels [begin, end) of a row that have equal
    /// sums, from left to right. The sums are `start` plus the contributions of the arcs. Removes
    /// the parts of the row. `visit` is compiled for every SIMD level together with the loop that
    /// calls it, and should capture by value (at_simd_level). Precondition: no arc is pending.
    template <class Visit>
    void take_row(int row, const Sums& start, const Visit& visit);

  private:
    static constexpr std::size_t kFlagsPerWord = 64;
    static constexpr std::size_t kFlagsPerStep = 4;  // see take_begins

    // A part of an arc in a row, as in ArcSplitter::Part.
    struct RowPart {
        std::int32_t column;
        std::int32_t twice_area;
        std::int32_t twice_area_on_left;
        std::uint32_t arc;  // index in across_
    };
    struct Row {
        std::vector<RowPart> parts;
        Sums start{};  // added to the start of the running sum
    };

    // The sums of a pixel in a SIMD register. If loops computed with arrays, compilers would copy
    // them through memory, in pieces of half a register, and every load of a whole register would
    // wait until both pieces are stored.
    struct VectorRegister {
        using Type [[gnu::vector_size(sizeof(Sums))]] = double;
    };
    struct ScalarRegister {
        using Type = double;
    };
    using Register =
        typename std::conditional_t<Channels == 1, ScalarRegister, VectorRegister>::Type;

    // Adds factor * values to the sums `to`, per channel.
    [[gnu::always_inline]] static void add_times(double factor, const Sums& values, Sums& to) {
        Register summand;
        Register sums;
        std::memcpy(&summand, &values, sizeof(summand));
        std::memcpy(&sums, &to, sizeof(sums));
        sums += factor * summand;
        std::memcpy(&to, &sums, sizeof(sums));
    }
    void add_parts(std::size_t k);
    void add_outside(const ArcSplitter::Part& part, std::uint32_t arc, Row& row);
    static std::size_t take_begins(std::span<std::uint64_t> flags, std::uint16_t* begins);

    int width_;
    RowKind kind_;
    ArcSplitter splitter_;
    KernelArray<Step, ArcSplitter::kMaxArcs> steps_;  // the steps of the pending arcs
    std::vector<Row> rows_;
    std::vector<Sums> across_;  // Step::across of each arc
    // Scratch arrays for one row. Between calls, all elements of cells_ and touched_ are 0.
    std::vector<Sums> cells_;             // see the class comment
    std::vector<std::uint64_t> touched_;  // one flag per pixel, set if it contains a part
    std::vector<std::uint16_t> begins_;   // the first pixel of each span of a row
};

// Spans begin at the first pixel of the row, at each pixel with a flag, and at the next pixel after
// each pixel with a flag. Stores these positions in increasing order, clears the flags, and returns
// the number of positions.
// Stores kFlagsPerStep positions at a time, and overwrites up to kFlagsPerStep - 1 elements after
// the last position. The end of a loop over single flags would often be mispredicted. So would the
// branch with which a search for the lowest flag handles a word without flags. Therefore the
// highest flag of the searched word is set. If the word has other flags, the lowest of them is
// still found.
template <std::size_t Channels>
[[gnu::always_inline]] inline std::size_t Coverage<Channels>::take_begins(
    std::span<std::uint64_t> flags, std::uint16_t* begins) {
    constexpr std::uint64_t kHighest = std::uint64_t{1} << (kFlagsPerWord - 1);
    std::size_t count = 0;
    std::uint64_t carry = 1;  // the lowest bit of the next word
    for (std::size_t word = 0; word < flags.size(); ++word) {
        std::uint64_t bits = flags[word] | flags[word] << 1 | carry;
        carry = flags[word] >> (kFlagsPerWord - 1);
        flags[word] = 0;
        const std::size_t end = count + static_cast<std::size_t>(std::popcount(bits));
        for (; count < end; count += kFlagsPerStep) {
            for (std::size_t k = 0; k < kFlagsPerStep; ++k) {
                const auto bit = static_cast<std::size_t>(std::countr_zero(bits | kHighest));
                begins[count + k] = static_cast<std::uint16_t>(word * kFlagsPerWord + bit);
                bits &= bits - 1;
            }
        }
        count = end;
    }
    return count;
}

// If the last pixel contains a part, the span that begins after it is dropped.
template <std::size_t Channels>
template <class Visit>
void Coverage<Channels>::take_row(int row, const Sums& start, const Visit& visit) {
    Row& own = rows_[static_cast<std::size_t>(row)];
    Sums first = start;
    add_times(1, std::exchange(own.start, Sums{}), first);
    at_simd_level([parts = std::span<const RowPart>(own.parts),
                   across = across_.data(),
                   touched = std::span<std::uint64_t>(touched_),
                   width = static_cast<std::size_t>(width_),
                   first,
                   cells = cells_.data(),
                   begins = begins_.data(),
                   visit] {
        for (const RowPart& part : parts) {
            const auto column = static_cast<std::size_t>(part.column);
            touched[column / kFlagsPerWord] |= std::uint64_t{1} << column % kFlagsPerWord;
            const Sums& step = across[part.arc];
            add_times(part.twice_area - part.twice_area_on_left, step, cells[column]);
            add_times(part.twice_area_on_left, step, cells[column + 1]);
        }
        std::size_t count = take_begins(touched, begins);
        if (begins[count - 1] == width) {
            --count;
        }
        begins[count] = static_cast<std::uint16_t>(width);
        Sums sums = first;
        for (std::size_t k = 0; k < count; ++k) {
            const std::size_t begin = begins[k];
            add_times(1, cells[begin], sums);
            cells[begin] = {};
            visit(begin, static_cast<std::size_t>(begins[k + 1]), sums);
        }
        cells[width] = {};
    });
    own.parts.clear();
}

}  // namespace foam::texgen
