#pragma once

#include "texgen/raster/coverage/arc_walk.h"
#include "texgen/raster/coverage/coverage_sums.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace foam::texgen {

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
/// says how they are stored (coverage_sums.h).
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
