#pragma once

#include "texgen/raster/arc_walk.h"
#include "texgen/raster/coverage_sums.h"

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace foam::texgen {

/// Whether a row of pixels goes around a torus, or ends on both sides.
enum class RowKind { Ring, Line };

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

    /// Walks along a row, left to right: writer.write(from, to) for each stretch of pixels [from,
    /// to) of one sum, writer.add(difference) where the sum changes, beginning with the difference
    /// from zero. Then clears the row.
    template <class Writer>
    void take_row(int row, Writer& writer);

  private:
    void add_run(const ArcWalk::Run& run, const Step& step);
    void add_around(const ArcWalk::Run& run, const Step& step);
    void add_outside(const ArcWalk::Run& run, const Step& step);
    void fetch_row(std::size_t row) const;
    void touch(std::size_t row, std::int32_t left, std::int32_t right);

    int width_;
    RowKind kind_;
    std::size_t
        stride_;  // pixels between rows; one more than the width takes what leaves on the right
    std::size_t words_;  // of 64 flags, per row
    std::vector<Sum> differences_;
    std::vector<std::uint64_t> touched_;  // a bit per pixel whose difference may not be zero
    ArcWalk walk_;
    std::vector<Sum> starts_;  // what the running sum of a row begins with
};

// Has the touched pixels of a row fetched before their turn.
template <class Sums>
void Coverage<Sums>::fetch_row(std::size_t row) const {
    if (row >= starts_.size()) {
        return;
    }
    const Sum* differences = &differences_[row * stride_];
    for (std::size_t word = 0; word < words_; ++word) {
        std::uint64_t bits = touched_[row * words_ + word];
        bits &= ~(bits << 1) | 0x5555555555555555;
        for (; bits != 0; bits &= bits - 1) {
            const std::size_t x = word * 64 + static_cast<std::size_t>(std::countr_zero(bits));
            __builtin_prefetch(differences + x, 1);
        }
    }
}

template <class Sums>
template <class Writer>
void Coverage<Sums>::take_row(int row, Writer& writer) {
    const auto index = static_cast<std::size_t>(row);
    Sum* differences = &differences_[index * stride_];
    std::uint64_t* touched = &touched_[index * words_];
    writer.add(std::exchange(starts_[index], Sum{}));
    fetch_row(index + 1);
    std::size_t from = 0;
    for (std::size_t word = 0; word < words_; ++word) {
        for (std::uint64_t bits = std::exchange(touched[word], 0); bits != 0; bits &= bits - 1) {
            const std::size_t x = word * 64 + static_cast<std::size_t>(std::countr_zero(bits));
            writer.write(from, x);
            writer.add(differences[x]);
            differences[x] = Sum{};
            from = x;
        }
    }
    writer.write(from, stride_ - 1);
}

extern template class Coverage<ExactSums<1>>;
extern template class Coverage<ExactSums<2>>;
extern template class Coverage<ExactSums<3>>;
extern template class Coverage<ExactSums<4>>;
extern template class Coverage<SmallSums<1>>;
extern template class Coverage<SmallSums<2>>;
extern template class Coverage<SmallSums<3>>;
extern template class Coverage<SmallSums<4>>;

}  // namespace foam::texgen
