// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/raster/arcs/pixel_arc.h"
#include "texgen/raster/outline/offset_arc.h"

#include <cstddef>
#include <span>
#include <vector>

namespace foam::texgen {

/// Finds the part of a region that its films leave free: all points at least a distance away from
/// all its sides. Its boundary consists of pieces of the sides' offsets and, around corners that
/// turn by more than 180 degrees, of circles.
///
/// Each offset is cut where it crosses another; a piece between two cuts belongs to the boundary
/// exactly if its middle keeps the distance. So sides that are too short to show drop out, a narrow
/// bubble falls into several parts, and one that is all film into none, without any case being told
/// apart. Where FullInsets finds an inset, it is the same to the last bit.
///
/// Buffers are reused between regions.
class InsetTracer {
  public:
    /// Traces the inset of a region that is on the left of all its loops, which go
    /// counter-clockwise around it, and clockwise around what is left out of it. Sides without a
    /// length are left out. Precondition: distance > 0, in pixels. The result is valid until the
    /// next call.
    const ArcLoops& trace(const ArcLoops& region, double distance);

    /// Traces one of the loops as if it were the only one.
    const ArcLoops& trace_loop(const ArcLoops& region, std::size_t loop, double distance);

  private:
    struct Offset {
        OffsetArc arc;
        std::size_t side = 0;  // whose offset it is; kCorner for a circle around a corner
    };
    struct Piece {
        std::size_t offset = 0;
        double from = 0.0;  // parameters
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
    std::vector<std::size_t> nearby_;  // sides that may come too near to one offset
    std::vector<Piece> pieces_;
};

}  // namespace foam::texgen
