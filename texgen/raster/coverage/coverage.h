#pragma once

#include "texgen/raster/coords/fixed_point.h"
#include "texgen/raster/coverage/arc_walk.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

namespace foam::texgen {

/// Bits of the area of a pixel. Areas are in half squares of a subpixel.
inline constexpr int kAreaBits = 2 * kSubpixelBits + 1;

inline constexpr std::int32_t kLargestMean = std::numeric_limits<std::uint16_t>::max();

/// Sums of 16-bit values times areas, per channel, in doubles, which are exact below 2^53. Channels
/// are rounded up to a power of two, with unused ones 0, so that they are vectorized.
template <std::size_t Channels>
struct ExactSums {
    using Number = double;
    using Sum = std::array<Number, std::bit_ceil(Channels)>;

    static constexpr double kPixel = std::int64_t{1} << kAreaBits;  // of coverage 1

    static Number of_area(std::int32_t area) { return area; }
    static Number of_value(std::int32_t value) { return value; }
    /// Returns what a row begins with if the value is `base` everywhere.
    static Number start(std::int32_t base) { return base * kPixel; }

    /// Returns sum / kPixel, rounded to the nearest. Clamped to the range of values, as arcs of an
    /// invalid foam may overlap.
    static std::int32_t mean(Number sum) {
        constexpr double kHalf = 0.5;  // makes truncation the nearest
        const auto mean = static_cast<std::int32_t>(sum * (1.0 / kPixel) + kHalf);
        return std::min(std::max(mean, 0), kLargestMean);
    }
};

/// Sums of areas rounded to 2^-15 pixel, in 32 bits, for means that become 8 bits. Sums wrap
/// around; values are counted from the middle of their range, which leaves half a range beyond
/// either end.
template <std::size_t Channels>
struct SmallSums {
    using Number = std::uint32_t;
    using Sum = std::array<Number, std::bit_ceil(Channels)>;

    static constexpr int kPixelBits = 15;
    static constexpr std::int32_t kMiddle = 1 << 15;

    /// Areas of whole heights are exact.
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

/// A row of pixels goes around a torus, or ends on both sides.
enum class RowKind { Ring, Line };

/// The sums along a row, in spans of one sum each. Its arrays only grow.
template <class Sum>
struct RowSums {
    std::size_t count = 0;
    std::vector<std::uint16_t> begins;  // where each span begins, and the width of the row
    std::vector<Sum> sums;
};

/// Accumulates signed areas: adds up arcs, each with the values on its sides per channel, over a
/// band of rows, so that a pixel ends with the sum of value times covered area.
///
/// Along a row, an arc adds its part of a pixel to that pixel and its height to all pixels on its
/// right. So the band holds differences from pixel to pixel, and a running sum along the row turns
/// them into values. Around the torus a row has no end, and the sum to the right of an arc would go
/// around forever. But the heights of each bubble's closed outline cancel in every row, so that
/// only differences of periods count: an arc that lies k periods to the right of the band subtracts
/// its height k times from the row's start. In the plane, an arc to the left of the row adds its
/// height to the whole row, and one to the right nothing.
///
/// All sums are of integers and exact, so that they do not depend on the order of the arcs. `Sums`
/// says how they are stored.
template <class Sums>
class Coverage {
  public:
    using Sum = typename Sums::Sum;

    /// What an arc adds to a row: the value on its right minus the value on its left, and the same
    /// with each value times the periods of its side.
    struct Step {
        Sum across{};
        Sum around{};
        bool goes_around = false;  // `around` is not 0
    };

    /// Begins with all differences zero. Width and rows are in pixels.
    Coverage(int width, int rows, RowKind kind = RowKind::Ring);

    /// Adds an arc, whose y is relative to the lower end of the band; the parts above and below the
    /// band are left out. Arcs are split in batches: the last ones wait for finish().
    void add(const MonotoneArc& arc, SubpixelPoint translation, const Step& step);

    /// Adds the arcs that are still waiting.
    void finish();

    /// Computes the sums along a row from left to right, `start` plus what arcs added, and clears
    /// the row.
    void take_row(int row, const Sum& start, RowSums<Sum>& sums);

  private:
    using Parts = std::span<const ArcWalk::Part>;

    bool is_inside(std::size_t arc) const {
        return walk_.leftmost(arc) >= 0 && walk_.rightmost(arc) < width_;
    }
    void add_inside(Parts parts, const Step& step);
    void add_outside(Parts parts, const Step& step);
    void add_around(Parts parts, const Step& step);

    int width_;
    RowKind kind_;
    std::size_t
        stride_;         // pixels between rows; one beyond the width takes what leaves on the right
    std::size_t words_;  // of 64 flags, per row
    std::vector<Sum> differences_;
    std::vector<std::uint64_t> touched_;  // a bit per pixel whose difference may not be zero
    ArcWalk walk_;
    std::array<Step, ArcWalk::kMaxArcs> steps_;  // of its arcs
    std::vector<Sum> starts_;                    // what the running sum of a row begins with
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
