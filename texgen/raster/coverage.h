#pragma once

#include "texgen/raster/arc_walk.h"
#include "texgen/raster/coverage_sums.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace foam::texgen {

/// Whether a row of pixels goes around a torus, or ends on both sides.
enum class RowKind { Ring, Line };

/// What the sums along a row are, in stretches. Its arrays only grow.
template <class Sum>
struct RowSums {
    std::size_t count = 0;
    std::vector<std::uint64_t> flags;   // a bit per pixel: whether a stretch begins there
    std::vector<std::uint16_t> begins;  // where those are, and the width of the row
    std::vector<Sum> sums;
};

/// Adds up arcs, each with the values on its sides per channel, over a band of rows, so that a
/// pixel ends with the sum of value times covered area.
///
/// Along a row, an arc adds its part of a pixel to that pixel and its height to all on its right.
/// So the band holds differences from pixel to pixel, and a running sum along the row turns them
/// into values. Around the torus a row has no end: the sum to the right of an arc goes round and
/// round. But the heights of each bubble's closed outline cancel in every row, so only differences
/// of rounds count: an arc that lies k periods to the right of the band takes its height k times
/// off the row's start. In the plane, an arc on the left of the row adds its height to the whole of
/// it, and one on the right nothing.
///
/// All sums are of integers and exact: they do not depend on the order of the arcs. `Sums` says how
/// they are held (coverage_sums.h).
template <class Sums>
class Coverage {
  public:
    using Sum = typename Sums::Sum;

    /// What an arc does to a row: the value on its right less that on its left, and the same with
    /// each value times the periods of its side.
    struct Step {
        Sum across{};
        Sum around{};
        bool goes_around = false;  // `around` is not 0
    };

    /// All differences are zero. Width and rows in pixels.
    Coverage(int width, int rows, RowKind kind = RowKind::Ring);

    /// An arc, its y relative to the lower end of the band. What lies above or below the band is
    /// left out.
    void add(const CellArc& arc, SubpixelPoint translation, const Step& step);

    /// Has the last arcs added, which wait for others.
    void finish();

    /// The sums along a row, from left to right: each holds from where it begins to where the next
    /// one does, the first from pixel 0 on, where every sum begins with `start`. Then clears the
    /// row.
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
    std::array<Step, ArcWalk::kMostArcs> steps_;  // of its arcs
    std::vector<Sum> starts_;                     // what the running sum of a row begins with
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
