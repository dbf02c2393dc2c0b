// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/raster/arcs/pixel_arc.h"
#include "texgen/raster/outline/offset_arc.h"

#include <cstddef>
#include <span>
#include <vector>

namespace foam::texgen {

/// Finds the inset of a region: all points whose distance from every side of the region is at least
/// a given distance. The boundary of the inset consists of pieces of the offsets of the sides and
/// of circular arcs around corners with an inner angle of more than 180 degrees.
///
/// Each offset is cut at its crossings with other offsets. A piece between two cuts belongs to the
/// boundary if and only if the middle of the piece keeps the distance. Sides that are too short to
/// be visible, bubbles that split into several parts and bubbles without an inset need no special
/// cases. If FullInsets also finds the inset of a loop, both results have the same bits.
///
/// Buffers are reused between regions.
class InsetTracer {
  public:
    /// Traces the inset of a region. The region is on the left of its loops: outer loops are
    /// counter-clockwise, loops around holes are clockwise. Sides with a chord of at
    /// most kShortestSide are ignored. `distance` is in pixels. The result is valid until the next
    /// call. Precondition: distance > 0.
    const ArcLoops& trace(const ArcLoops& region, double distance);

    /// Traces one of the loops as if it were the only one.
    const ArcLoops& trace_loop(const ArcLoops& region, std::size_t loop, double distance);

  private:
    struct Offset {
        OffsetArc arc;
        std::size_t side = 0;  // index of its side; kCorner for an arc around a corner
    };
    struct Piece {
        std::size_t offset = 0;
        double from = 0.0;  // parameters on the offset
        double to = 0.0;
        Point tail;
        Point head;
        bool linked = false;
    };

    void begin(double distance);
    void add_loop(std::span<const ArcLoops::Side> loop);
    const ArcLoops& trace_pieces();
    void collect_offsets(std::size_t first, std::size_t end);
    void collect_cuts(const Offset& offset);
    void collect_nearby(const Offset& offset);
    void collect_pieces(std::size_t index);
    bool keeps_distance(Point point) const;
    Piece* successor(const Piece& piece, const Piece& first);
    void link_loop(Piece& first);

    std::vector<OffsetArc> sides_;
    double distance_ = 0.0;
    std::vector<Offset> offsets_;
    ArcLoops loops_;

    std::vector<double> cuts_;         // parameters along one offset
    std::vector<std::size_t> nearby_;  // indices of sides that may be too near to one offset
    std::vector<Piece> pieces_;
};

}  // namespace foam::texgen
