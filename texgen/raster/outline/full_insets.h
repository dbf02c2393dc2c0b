// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/raster/arcs/pixel_arc.h"

#include <array>
#include <cstddef>
#include <memory>
#include <vector>

namespace foam::texgen {

/// Pieces of offsets that are shorter are left out; pixels. A longer piece is long enough that its
/// middle, in front of a side that leans on it, is seen to be too near.
inline constexpr double kShortestPiece = 1e-6;

/// Finds the insets of loops of which every side shows, as of most bubbles: the offset of each side
/// is then cut only by those of its neighbors. Bounds of the distances of all pieces from all sides
/// prove that. The sides of many loops are computed at once, up to some 500 of them; what is beyond
/// is not proven to show.
///
/// Buffers are reused between calls.
class FullInsets {
  public:
    /// Computes the insets of closed loops, each with its region on its left. Precondition:
    /// distance > 0, in pixels.
    void trace(const ArcLoops& outlines, double distance);

    /// Returns true if it is proven that every side of a loop shows in its inset.
    bool shows_every_side(std::size_t loop) const { return loops_[loop].shows_every_side; }

    /// Appends the inset of a loop. Precondition: every side of it shows.
    void append_inset(std::size_t loop, ArcLoops& to) const;

  private:
    struct Loop {
        std::size_t begin = 0;  // in the columns
        std::size_t size = 0;
        bool shows_every_side = false;
    };

    // One number per side. Each loop is followed by its first side once more, so that the side
    // after side k is side k + 1. As members of one object, columns are known not to overlap, so
    // that compilers vectorize loops over them.
    static constexpr std::size_t kCapacity = 512;
    using Column = std::array<double, kCapacity>;
    struct alignas(64) Columns {
        Column tail_x, tail_y, chord_x, chord_y, cosine, sine;
        Column middle_x, middle_y, along_x, along_y, curvature;
        Column offset_x, offset_y, offset_curvature, offset_reach;
        Column from, to;          // parameters where its neighbors cut the offset off
        Column point_x, point_y;  // the tail of what is left of the offset
        Column piece_cosine, piece_sine;
        Column fits;  // 1 if the offset exists and crosses the next one once, else 0
    };

    struct Formulas;

    std::size_t fill_columns(const ArcLoops& outlines);

    std::vector<Loop> loops_;
    std::unique_ptr<Columns> columns_ = std::make_unique<Columns>();
};

}  // namespace foam::texgen
