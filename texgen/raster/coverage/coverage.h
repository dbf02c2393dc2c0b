// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/raster/coords/fixed_point.h"
#include "texgen/raster/coverage/arc_splitter.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

namespace foam::texgen {

/// The area of a pixel is 2^kAreaBits. The unit of areas is half a square subpixel.
inline constexpr int kAreaBits = 2 * kSubpixelBits + 1;

/// The largest value of a mean.
inline constexpr std::int32_t kLargestMean = std::numeric_limits<std::uint16_t>::max();

/// Sums of 16-bit values times areas, per channel. They are stored as doubles, which are exact for
/// integers below 2^53. The number of channels is rounded up to a power of two, so that they are
/// vectorized; unused channels are 0.
template <std::size_t Channels>
struct ExactSums {
    using Number = double;
    using Sum = std::array<Number, std::bit_ceil(Channels)>;

    static constexpr double kPixel = std::int64_t{1} << kAreaBits;  // area of a pixel

    static Number of_area(std::int32_t area) { return area; }
    static Number of_value(std::int32_t value) { return value; }
    /// Returns the sum at the start of a row whose value is `base` everywhere.
    static Number start(std::int32_t base) { return base * kPixel; }

    /// Returns sum / kPixel, rounded to the nearest. The result is clamped to the range of values,
    /// because arcs of an invalid foam may overlap.
    static std::int32_t mean(Number sum) {
        constexpr double kHalf = 0.5;  // added before truncation, which rounds to the nearest
        const auto mean = static_cast<std::int32_t>(sum * (1.0 / kPixel) + kHalf);
        return std::min(std::max(mean, 0), kLargestMean);
    }
};

/// Sums of values times areas that are rounded to 2^-15 pixel, in integers of 32 bits, for images
/// of 8 bits. Unsigned arithmetic wraps around, so that intermediate overflows do no harm. Values
/// are counted from the middle of their range; this leaves room for means that exceed the range by
/// up to half its size on either side, and are then clamped.
template <std::size_t Channels>
struct SmallSums {
    using Number = std::uint32_t;
    using Sum = std::array<Number, std::bit_ceil(Channels)>;

    static constexpr int kPixelBits = 15;
    static constexpr std::int32_t kMiddle = 1 << 15;

    /// Rounds an area to 2^-15 pixel. ArcSplitter::Part::whole is a multiple of this unit, and so
    /// stays exact.
    static Number of_area(std::int32_t area) {
        constexpr int kDropped = kAreaBits - kPixelBits;
        return static_cast<Number>((area + (1 << (kDropped - 1))) >> kDropped);
    }
    static Number of_value(std::int32_t value) { return static_cast<Number>(value); }
    static Number start(std::int32_t base) {
        return static_cast<Number>((base - kMiddle) * (1 << kPixelBits));
    }

    static std::int32_t mean(Number sum) {
        constexpr Number kHalf = 1 << (kPixelBits - 1);
        const std::int32_t mean = (static_cast<std::int32_t>(sum + kHalf) >> kPixelBits) + kMiddle;
        return std::min(std::max(mean, 0), kLargestMean);
    }
};

/// The topology of a row of pixels: a ring around a torus, or a line that ends on both sides.
enum class RowKind { Ring, Line };

/// The sums along a row, as spans of pixels with equal sums. Only the first `count` spans are
/// valid; the arrays never shrink.
template <class Sum>
struct RowSums {
    std::size_t count = 0;
    std::vector<std::uint16_t> begins;  // the first pixel of each span, and the width of the row
    std::vector<Sum> sums;
};

/// Accumulates signed areas over a band of rows. Each arc is added with the values on its two
/// sides, per channel. The result for a pixel is the sum of value times covered area.
///
/// Along a row, an arc adds its part of a pixel to that pixel, and its height to all pixels on its
/// right. The band therefore stores differences from pixel to pixel, and a running sum along the
/// row turns them into values.
///
/// On a torus a row is a ring, so that "to the right" has no end. The heights of each bubble's
/// closed outline cancel in every row, however, so that only differences of periods matter: an arc
/// that is k periods to the right of the band subtracts its height k times from the start of the
/// row. In the plane, an arc to the left of the row adds its height to the whole row, and an arc to
/// the right of the row adds nothing.
///
/// All sums are exact sums of integers, so that they do not depend on the order of the arcs. `Sums`
/// (ExactSums or SmallSums) determines how they are stored.
template <class Sums>
class Coverage {
  public:
    using Sum = typename Sums::Sum;

    /// The change of values from the left of an arc to its right.
    struct Step {
        Sum across{};        // value on the right minus value on the left
        Sum around{};        // the difference of the values times the periods of their sides
        bool wraps = false;  // true if `around` may not be 0
    };

    /// Creates a band whose differences are all zero. Width and rows are in pixels.
    Coverage(int width, int rows, RowKind kind = RowKind::Ring);

    /// Adds an arc, moved by a translation. Its y is relative to the lower border of the band;
    /// parts above and below the band are ignored. Arcs are split in batches, so the last arcs are
    /// pending until finish() is called.
    void add(const MonotoneArc& arc, SubpixelPoint translation, const Step& step);

    /// Adds all pending arcs.
    void finish();

    /// Computes the sums along a row from left to right, which is `start` plus the contributions of
    /// arcs, and clears the row. Precondition: no arc is pending.
    void take_row(int row, const Sum& start, RowSums<Sum>& sums);

  private:
    using Parts = std::span<const ArcSplitter::Part>;
    struct Band;

    bool is_inside(std::size_t arc) const {
        return splitter_.leftmost(arc) >= 0 && splitter_.rightmost(arc) < width_;
    }
    void add_inside(Parts parts, const Step& step);
    void add_outside(Parts parts, const Step& step);
    void add_around(Parts parts, const Step& step);

    int width_;
    RowKind kind_;
    std::size_t stride_;  // pixels between rows; one pixel beyond the width receives what an arc
                          // adds to the right of the last pixel
    std::size_t words_;   // words of 64 flags per row
    std::vector<Sum> differences_;
    std::vector<std::uint64_t>
        touched_;  // one bit per pixel, set if its difference may not be zero
    ArcSplitter splitter_;
    std::array<Step, ArcSplitter::kMaxArcs> steps_;  // the steps of the pending arcs
    std::vector<Sum> starts_;                        // added to the start of each row's running sum
};

extern template class Coverage<ExactSums<1>>;
extern template class Coverage<ExactSums<2>>;
extern template class Coverage<ExactSums<3>>;
extern template class Coverage<ExactSums<4>>;
extern template class Coverage<SmallSums<1>>;
extern template class Coverage<SmallSums<2>>;
extern template class Coverage<SmallSums<3>>;
extern template class Coverage<SmallSums<4>>;

}  // namespace foam::texgen
