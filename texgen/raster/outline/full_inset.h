// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/raster/arcs/pixel_arc.h"
#include "texgen/raster/outline/offset_arc.h"

#include <span>
#include <vector>

namespace foam::texgen {

/// The smallest length of a piece of an offset, in pixels. Length means here the difference of the
/// parameters (OffsetArc) of the two ends of the piece. InsetTracer (inset.h) drops shorter pieces;
/// FullInset (below) returns null for a loop with such a piece.
///
/// The reason is the test by which InsetTracer decides whether to keep a piece. The middle of the
/// piece must have the required distance from all other sides, with a tolerance of 1e-7 pixels. The
/// middle of a short piece is close to the offset that cuts the piece. Its distance from the side
/// of that offset is therefore close to the required distance. If it is below the required
/// distance, but by less than the tolerance, the test keeps the piece, which should be dropped.
inline constexpr double kShortestPiece = 1e-6;

/// Finds the inset of a loop (inset.h) if the boundary of the inset provably has a simple form. In
/// this form, the inset is full: each side of the loop contributes exactly one piece of its offset.
/// The piece is cut only by the offsets of the two adjacent sides. The proof is a lower bound of
/// the distance of every piece from every other side. It succeeds for most bubbles. Buffers are
/// reused between loops.
class FullInset {
  public:
    /// Returns the inset of a closed loop, whose region is on its left. Returns null if the code
    /// cannot prove that the inset has the simple form. The result is valid until the next call.
    /// `distance` is in pixels. Precondition: distance > 0.
    const ArcLoops* trace(std::span<const ArcLoops::Side> loop, double distance);

  private:
    // A side, and the piece of its offset between the crossings with adjacent offsets.
    struct Side {
        OffsetArc arc;
        OffsetArc offset;
        double from = 0.0;  // parameters (OffsetArc) of the ends of the piece
        double to = 0.0;
        Vec2 tail{0.0, 0.0};  // tail of the piece
    };

    // Returns side k, counted around the loop. Precondition: k < 2 sides_.size().
    Side& side(std::size_t k) { return sides_[k < sides_.size() ? k : k - sides_.size()]; }
    bool offset_sides(std::span<const ArcLoops::Side> loop, double distance);
    bool cut_corners();
    bool keeps_clear_of(std::size_t k, double distance);

    std::vector<Side> sides_;
    ArcLoops inset_;
};

}  // namespace foam::texgen
