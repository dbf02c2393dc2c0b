// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/raster/arcs/pixel_arc.h"

#include <array>
#include <cstddef>
#include <memory>
#include <vector>

namespace foam::texgen {

/// The offsets of the sides of a loop (FullInsets, below) cut each other into pieces. InsetTracer
/// (inset.h) drops a piece if the parameters (OffsetArc) of its ends differ by less than this, in
/// pixels; FullInsets proves nothing for a loop with such a piece. The reason is that InsetTracer
/// keeps a piece if its middle has the required distance from every side, with a tolerance of 1e-7
/// pixels. A piece ends where it crosses the offset of another side. Just before and just behind
/// this crossing, the distance from that side equals the required distance within the tolerance, so
/// that a short piece to drop would pass the test, too. The middle of a longer piece is far enough
/// from the crossing, unless the two offsets are nearly parallel.
inline constexpr double kShortestPiece = 1e-6;

/// Finds the insets of loops. The inset of a loop consists of all points of its region whose
/// distance from every side is at least a given distance. The offset of a side is the arc at this
/// distance on its left. A side is visible in the inset if a piece of its offset is part of the
/// boundary of the inset.
///
/// FullInsets finds the inset of a loop only if every side is visible, which is true of most
/// bubbles. The offset of each side is then cut only by the offsets of the two adjacent sides.
/// Bounds on the distances of all pieces from all sides prove that every side is visible.
///
/// The sides of many loops are stored as a structure of arrays, so that each formula is computed
/// for several sides at once. The capacity is about 500 sides, where each
/// loop counts as one side more than it has. shows_every_side is false for a loop
/// that does not fit, or that has fewer than kFewestSides sides. Buffers are reused between calls.
class FullInsets {
  public:
    static constexpr std::size_t kFewestSides = 3;

    /// Tries to find the insets of closed loops, each by itself. The region of a loop is on the
    /// left of the loop. `distance` is in pixels. Precondition: distance > 0.
    void trace(const ArcLoops& outlines, double distance);

    /// Returns true if trace() has proven that every side of a loop is visible in the inset of the
    /// loop.
    bool shows_every_side(std::size_t loop) const { return loops_[loop].shows_every_side; }

    /// Appends the inset of a loop to `to`. Precondition: shows_every_side(loop).
    void append_inset(std::size_t loop, ArcLoops& to) const;

  private:
    struct Loop {
        std::size_t begin = 0;  // index of the first side in the columns
        std::size_t size = 0;
        bool shows_every_side = false;
    };

    // A column has one number per side. The first side of each loop is repeated after the last side
    // of the loop, so that the side after side k is always side k + 1. Because the columns are
    // members of one object, compilers know that they do not overlap, and vectorize loops over
    // them.
    static constexpr std::size_t kCapacity = 512;
    using Column = std::array<double, kCapacity>;
    struct alignas(64) Columns {
        Column tail_x, tail_y, chord_x, chord_y, cosine, sine;
        Column middle_x, middle_y, along_x, along_y, curvature;
        Column offset_x, offset_y, offset_curvature, offset_reach;
        Column from, to;          // OffsetArc parameters at which adjacent offsets cut the offset
        Column point_x, point_y;  // tail of the piece between these cuts
        Column piece_cosine, piece_sine;  // of half the angle by which the piece turns left
        Column passes_tests;              // 1 if the side has passed all tests so far, else 0
    };

    struct Formulas;

    std::size_t fill_columns(const ArcLoops& outlines);

    std::vector<Loop> loops_;
    std::unique_ptr<Columns> columns_ = std::make_unique<Columns>();
};

}  // namespace foam::texgen
