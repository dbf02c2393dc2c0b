#pragma once

#include "texgen/raster/field_arc.h"

#include <array>
#include <cstddef>
#include <cstdint>

namespace foam::texgen {

/// Distances and smooth distances in a square of pixels, from arcs that are added one by one. All
/// arithmetic is in floats relative to the middle of the square, where the arcs' functions are
/// known: so nothing cancels, and how far the arcs reach does not matter.
class DistanceTile {
  public:
    static constexpr int kSide = 8;
    /// From the middle of the square to the centre of the farthest pixel.
    static constexpr double kReach = 3.5 * 1.4142135623730951;

    using Values = std::array<float, std::size_t{kSide} * kSide>;

    /// Begins anew. Bit k of `rows` says whether row k is wanted; others keep arbitrary values.
    void reset(std::uint8_t rows);

    /// An arc, by its functions at the middle of the square. Counts where pixels face it.
    void add_arc(const Quadratic& across, const EndNormals& ends);

    /// A point, relative to the middle of the square.
    void add_point(const Vec2& point);

    /// Whether a wanted pixel faces none of the arcs, and no point was added.
    bool is_unresolved() const;

    /// Makes unit vectors of the gradients. Before that they are of any length.
    void normalize_gradients();

    /// A film that is smoothly joined with all others, by its pencil at the middle of the square.
    void add_film(const Pencil& pencil, double chord);

    /// Makes the sums of all films smooth distances. Where there are none it is the distance;
    /// its gradient has to be normalized before.
    void finish_smooth();

    const Values& distance() const { return distance_; }
    const Values& gradient_x() const { return gradient_x_; }
    const Values& gradient_y() const { return gradient_y_; }
    const Values& smooth() const { return smooth_; }
    const Values& smooth_x() const { return smooth_x_; }
    const Values& smooth_y() const { return smooth_y_; }

  private:
    bool is_wanted(int row) const { return ((rows_ >> row) & 1) != 0; }

    std::uint8_t rows_ = 0;
    alignas(32) Values distance_{};
    alignas(32) Values gradient_x_{};
    alignas(32) Values gradient_y_{};
    alignas(32) Values smooth_{};  // sums, until they are finished
    alignas(32) Values smooth_x_{};
    alignas(32) Values smooth_y_{};
};

}  // namespace foam::texgen
