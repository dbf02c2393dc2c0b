// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/raster/arcs/pixel_arc.h"
#include "texgen/raster/outline/offset_arc.h"

#include <span>
#include <vector>

namespace foam::texgen {

/// InsetTracer (inset.h) drops a piece of an offset if the parameters (OffsetArc) of its ends
/// differ by less than this, in pixels; FullInset (below) proves nothing for a loop with such a
/// piece. The middle of a short piece is so close to the offset at which the piece ends that the
/// test of its distance, which has a tolerance of 1e-7 pixels, would not detect that it is too
/// near.
inline constexpr double kShortestPiece = 1e-6;

/// Finds the inset of a loop (inset.h) if it can prove that a piece of the offset of every side is
/// part of the boundary of the inset, which is true of most bubbles. The offset of each side is
/// then cut only by the offsets of the two adjacent sides. The proof uses bounds on the distances
/// of all pieces from all sides. Buffers are reused between loops.
class FullInset {
  public:
    /// Returns the inset of a closed loop, whose region is on its left, or null if it is not proven
    /// that every side is visible. The result is valid until the next call. `distance` is in
    /// pixels. Precondition: distance > 0.
    const ArcLoops* trace(std::span<const ArcLoops::Side> loop, double distance);

  private:
    // A side, and the piece of its offset between the crossings with adjacent offsets.
    struct Side {
        OffsetArc arc;
        OffsetArc offset;
        double from = 0.0;  // parameters (OffsetArc) of the ends of the piece
        double to = 0.0;
        Vec2 tail{0.0, 0.0};  // of the piece
    };

    // Returns side k, counted around the loop. Precondition: k is less than twice their number.
    Side& side(std::size_t k) { return sides_[k < sides_.size() ? k : k - sides_.size()]; }
    bool offset_sides(std::span<const ArcLoops::Side> loop, double distance);
    bool cut_corners();
    bool keeps_clear_of(std::size_t k, double distance);

    std::vector<Side> sides_;
    ArcLoops inset_;
};

}  // namespace foam::texgen
