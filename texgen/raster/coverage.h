#pragma once

#include "texgen/raster/edge_walk.h"

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace foam::texgen {

/// A pixel of exact coverage 1 counts this much: twice the square of kSubpixel, as the area left of
/// an edge comes in half squares of a subpixel.
inline constexpr int kCoverageBits = 2 * kSubpixelBits + 1;

/// Whether a row of pixels goes around a torus, or ends on both sides.
enum class RowKind { Ring, Line };

/// Adds up outlines, each with a value per channel, over a band of rows, so that a pixel ends with
/// the sum of value times covered area.
///
/// Along a row, an edge adds its part of a pixel to that pixel and its height to all on its right.
/// So the band holds differences from pixel to pixel, and a running sum along the row turns them
/// into values. Around the torus a row has no end: the sum to the right of an edge goes round and
/// round. But the heights of a closed outline cancel in every row, so only differences of rounds
/// count: an edge that lies k periods to the right of the band takes its height k times off the
/// row's start. In the plane, an edge on the left of the row adds its height to the whole of it,
/// and one on the right nothing.
///
/// All sums are of integers and exact: they do not depend on the order of the outlines. They are
/// held as doubles, which processors take several of at once, and stay below 2^53. An edge is
/// split into pixels the same way in both directions and in every place, so that two outlines that
/// share one leave neither gap nor overlap.
template <std::size_t Channels>
class Coverage {
  public:
    using Value = std::array<std::int32_t, Channels>;
    /// Of each channel; rounded up to a power of two, the others being 0.
    using Sum = std::array<double, std::bit_ceil(Channels)>;

    /// All differences are zero. Width and rows in pixels.
    Coverage(int width, int rows, RowKind kind = RowKind::Ring);

    /// A closed chain, on a torus unwrapped in x, its y relative to the lower end of the band;
    /// counter-clockwise chains add, the others subtract. What lies above or below the band is left
    /// out.
    void add(std::span<const SubpixelPoint> chain, SubpixelPoint translation, const Value& value) {
        add(chain, 0, chain.size(), translation, value);
    }

    /// Of a closed chain the edges that lead to the points [begin, end).
    void add(std::span<const SubpixelPoint> chain,
             std::size_t begin,
             std::size_t end,
             SubpixelPoint translation,
             const Value& value);

    /// Walks along a row, left to right: writer.write(from, to) for each stretch of pixels [from,
    /// to) of one sum, writer.add(difference) where the sum changes, beginning with the difference
    /// from zero. Sums count in units of 2^-kCoverageBits. Then clears the row.
    template <class Writer>
    void take_row(int row, Writer& writer);

  private:
    void add_part(const PixelPart& part, const Sum& value);
    std::int32_t wrap_part(const PixelPart& part, const Sum& value);
    void add_past_border(std::int32_t row, double height, const Sum& value);
    void touch_two(std::size_t row_words, std::size_t x);

    int width_;
    int rows_;
    RowKind kind_;
    std::size_t
        stride_;  // pixels between rows; one more than the width takes what leaves on the right
    std::size_t words_;  // of 64 flags, per row
    std::vector<Sum> differences_;
    std::vector<std::uint64_t> touched_;  // a bit per pixel whose difference may not be zero
    std::vector<Sum> starts_;             // what the running sum of a row begins with
};

template <std::size_t Channels>
template <class Writer>
void Coverage<Channels>::take_row(int row, Writer& writer) {
    const auto index = static_cast<std::size_t>(row);
    Sum* differences = &differences_[index * stride_];
    std::uint64_t* touched = &touched_[index * words_];
    writer.add(std::exchange(starts_[index], Sum{}));
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

extern template class Coverage<1>;
extern template class Coverage<2>;
extern template class Coverage<3>;
extern template class Coverage<4>;

}  // namespace foam::texgen
