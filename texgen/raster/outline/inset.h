// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/raster/arcs/pixel_arc.h"
#include "texgen/raster/outline/disc_index.h"
#include "texgen/raster/outline/offset_arc.h"

#include <span>
#include <vector>

namespace foam::texgen {

/// Finds the inset of a region: all points of the region whose distance from every side of the
/// region is at least a given distance. The offset of a side is the arc at this distance on the
/// left of the side. The offset of a corner with an inner angle of more than 180 degrees is a
/// circular arc around the corner. The inner angle may be 360 degrees, at the end of a slit: the
/// boundary runs along the slit to its end and back along its other side, with the region on both
/// sides. Each offset is cut at its crossings with all other offsets. The middle of a piece between
/// two cuts decides whether the piece belongs to the boundary of the inset. The middle must have at
/// least the given distance from all other sides.
///
/// FullInset (full_inset.h) finds the insets of most loops faster. Its results have the same bits
/// as the results of this class. An InsetTracer reuses its buffers between regions. For n sides, it
/// takes time proportional to n log n if only a bounded number of sides is near each side, and
/// otherwise at most proportional to n³.
class InsetTracer {
  public:
    /// Returns the boundary loops of the inset of a region. Both the region and the inset are on
    /// the left of their loops: outer loops are counter-clockwise, and loops around holes are
    /// clockwise. Sides with a chord of at most kShortestChord are ignored. `distance` is in
    /// pixels. The result is valid until the next call. Precondition: distance > 0.
    const ArcLoops& trace(const ArcLoops& region, double distance);

    /// Returns the boundary loops of the inset of the region that a single loop of `region` bounds.
    const ArcLoops& trace_loop(const ArcLoops& region, std::size_t loop, double distance);

  private:
    struct Offset {
        OffsetArc arc;
        std::size_t side = 0;  // index of the side; kCorner if this is the offset of a corner
    };
    struct Piece {
        std::size_t offset = 0;  // index of the offset
        double from = 0.0;       // parameter of the tail on the offset (see OffsetArc)
        double to = 0.0;         // parameter of the head on the offset
        Vec2 tail{0.0, 0.0};
        Vec2 head{0.0, 0.0};
        // True if the piece was already used in a loop, even if this loop did not close.
        bool linked = false;
    };

    void add_loop(std::span<const ArcLoops::Side> loop);
    void collect_cuts(const Offset& offset);
    void collect_nearby(const Offset& offset);
    void collect_pieces(std::size_t index);
    bool keeps_distance(const Vec2& point) const;
    Piece* successor(const Piece& piece, const Piece& first);
    void link_loop(Piece& first);

    std::vector<OffsetArc> sides_;
    double distance_ = 0.0;
    std::vector<Offset> offsets_;
    ArcLoops loops_;

    std::vector<double> cuts_;         // parameters at which the current offset is cut
    std::vector<std::size_t> nearby_;  // indices of sides that may be near the current offset
    std::vector<Piece> pieces_;
    DiscIndex side_index_;
    DiscIndex offset_index_;
    DiscIndex piece_index_;
};

}  // namespace foam::texgen
