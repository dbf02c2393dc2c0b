// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/raster/arcs/pixel_arc.h"

#include <array>
#include <cstddef>
#include <memory>
#include <vector>

namespace foam::texgen {

/// The length in pixels below which a piece of an offset is dropped. A piece of at least this
/// length is long enough for InsetTracer to detect that a side at an angle to the piece is too near
/// to its middle.
inline constexpr double kShortestPiece = 1e-6;

/// Finds the insets of loops all of whose sides are visible in the inset. Most bubbles have such
/// loops. The offset of each side is then cut only by the offsets of the two neighboring sides.
/// Bounds on the distances of all pieces from all sides prove that this is the case.
///
/// The sides of many loops are stored as a structure of arrays and computed at once. The capacity
/// is about 500 sides. A loop that does not fit counts as not proven. Buffers are reused between
/// calls.
class FullInsets {
  public:
    /// Computes the insets of closed loops. Each loop has its region on its left. `distance` is in
    /// pixels. Precondition: distance > 0.
    void trace(const ArcLoops& outlines, double distance);

    /// Returns true if it is proven that every side of a loop is visible in the inset of the loop.
    bool shows_every_side(std::size_t loop) const { return loops_[loop].shows_every_side; }

    /// Appends the inset of a loop. Precondition: shows_every_side(loop).
    void append_inset(std::size_t loop, ArcLoops& to) const;

  private:
    struct Loop {
        std::size_t begin = 0;  // index of the first side in the columns
        std::size_t size = 0;
        bool shows_every_side = false;
    };

    // A column has one number per side. The first side of each loop is repeated after its last
    // side, so that side k + 1 always follows side k. Because the columns are members of one
    // object, compilers know that they do not overlap, and vectorize loops over them.
    static constexpr std::size_t kCapacity = 512;
    using Column = std::array<double, kCapacity>;
    struct alignas(64) Columns {
        Column tail_x, tail_y, chord_x, chord_y, cosine, sine;
        Column middle_x, middle_y, along_x, along_y, curvature;
        Column offset_x, offset_y, offset_curvature, offset_reach;
        Column from, to;          // parameters at which the neighbors cut the offset
        Column point_x, point_y;  // the tail of the piece that remains of the offset
        Column piece_cosine, piece_sine;
        Column fits;  // 1 if the side has passed all tests so far, else 0
    };

    struct Formulas;

    std::size_t fill_columns(const ArcLoops& outlines);

    std::vector<Loop> loops_;
    std::unique_ptr<Columns> columns_ = std::make_unique<Columns>();
};

}  // namespace foam::texgen
