// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/raster/coords/fixed_point.h"
#include "texgen/raster/coverage/arc_splitter.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

namespace foam::texgen {

/// The binary logarithm of the area of a pixel. The unit of areas is half a square subpixel.
inline constexpr int kAreaBits = 2 * kSubpixelBits + 1;

/// The largest possible mean of 16-bit values.
inline constexpr std::int32_t kLargestMean = std::numeric_limits<std::uint16_t>::max();

/// The area of a pixel.
inline constexpr double kPixelArea = 1 << kAreaBits;

/// The sums of a pixel, one per channel: 16-bit values times areas. A double represents them
/// exactly, because they are integers below 2^53. The number of channels is rounded up to a power
/// of two, so that loops over channels are vectorized; unused channels are 0.
template <std::size_t Channels>
using PixelSums = std::array<double, std::bit_ceil(Channels)>;

/// Returns the mean value of a pixel, sum / kPixelArea, rounded to the nearest integer. The result
/// is clamped to the range of values, because the mean may be outside of this range where rafts
/// overlap or the foam is invalid.
inline std::uint16_t mean_of(double sum) {
    constexpr double kHalf = 0.5;  // added before truncation, which rounds to the nearest
    const auto mean = static_cast<std::int32_t>(sum * (1.0 / kPixelArea) + kHalf);
    return static_cast<std::uint16_t>(std::min(std::max(mean, 0), kLargestMean));
}

/// The topology of a row of pixels: a ring around a torus, or a line segment in the plane.
enum class RowKind { Ring, Line };

/// The sums along a row, as spans of pixels with equal sums. The arrays never shrink.
template <std::size_t Channels>
struct RowSums {
    std::size_t count = 0;              // number of spans
    std::vector<std::uint16_t> begins;  // the first pixel of each span, then the width of the row
    std::vector<PixelSums<Channels>> sums;  // the sums of each pixel of a span
};

/// Computes sums of values times areas in a band of rows. Each arc is added with the change of the
/// values from its left to its right, per channel. The sum of a pixel is a start value plus the
/// contributions of all arcs: sums of integers, which do not depend on the order of the arcs.
///
/// In each row, an arc adds its change of values times the area on its right. In the pixel of a
/// part of the arc (ArcSplitter::Part), this is the area between the part and the right border of
/// the pixel. In each pixel further right, it is the height of the part times the width of a pixel.
/// The band stores the parts of each row in a list. When the row is taken, its parts are added to
/// one cell per pixel, and a running sum along the row converts the cells to sums of pixels.
///
/// On a torus, an arc outside of the image is added at its wrapped column. The sums would be right
/// if all arcs of an outline were in the same period, because their signed heights then cancel in
/// every row. Wrapping an arc from k periods further right adds k times its full contribution
/// (height times pixel width times change of values) too much to every pixel of its rows. This
/// amount is subtracted at the start of each of these rows. In the plane, an arc to the left of the
/// image adds its full contribution to all pixels of its rows; an arc to the right adds nothing.
template <std::size_t Channels>
class Coverage {
  public:
    using Sums = PixelSums<Channels>;

    /// The change of values from the left of an arc to its right.
    struct Step {
        Sums across{};  // value on the right minus value on the left
        // Corrects the starts of rows for an arc whose unwrapped outlines are beyond the border of
        // the torus, with a k for each side (ArcSides): the value on the right times right_periods
        // minus the value on the left times left_periods.
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

    /// Stores the sums of the pixels of a row, `start` plus the contributions of the arcs, and
    /// removes the parts of the row. Precondition: no arc is pending.
    void take_row(int row, const Sums& start, RowSums<Channels>& sums);

  private:
    // A part of an arc in a row, as in ArcSplitter::Part.
    struct RowPart {
        std::int32_t column;
        std::int32_t twice_area;
        std::int32_t twice_area_on_left;
        std::uint32_t arc;  // index in across_
    };
    // The contributions of parts to the sums of the pixels of a row.
    struct alignas(2 * sizeof(Sums)) Cell {
        Sums all{};   // added to the pixel of a part and to all pixels further right
        Sums left{};  // subtracted from the pixel of a part
    };
    struct Row {
        std::vector<RowPart> parts;
        Sums start{};  // added to the start of the running sum
    };

    void add_parts(std::size_t k);
    void add_outside(const ArcSplitter::Part& part, std::uint32_t arc, Row& row);

    int width_;
    RowKind kind_;
    ArcSplitter splitter_;
    std::array<Step, ArcSplitter::kMaxArcs> steps_;  // the steps of the pending arcs
    std::vector<Row> rows_;
    std::vector<Sums> across_;  // Step::across of each arc
    // Scratch arrays for one row; all elements are 0 between calls.
    std::vector<Cell> cells_;
    std::vector<std::uint64_t> touched_;  // one flag per pixel, set if its cell may be nonzero
};

}  // namespace foam::texgen
