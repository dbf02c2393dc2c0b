#pragma once

#include "texgen/raster/arcs/pixel_arc.h"
#include "texgen/raster/side_arc.h"

#include <cstddef>
#include <span>
#include <vector>

namespace foam::texgen {

/// A piece of an inset that is shorter, in pixels, is left out.
inline constexpr double kShortestPiece = 1e-6;

/// Finds the part of a bubble that its films leave free: all its points at least a distance away
/// from all its sides. That part is bounded by the sides' offsets alone, wherever two sides meet at
/// less than 180 degrees, and by circles around the other corners.
///
/// Each offset is cut where it crosses another; a piece between two cuts belongs to the boundary
/// exactly if its middle keeps the distance. So sides that are too short to show drop out, a narrow
/// bubble may fall into several parts, and one that is all film into none, without any case being
/// told apart. Where every side shows, PlainInsets finds the same more quickly. Keeps its working
/// memory from one bubble to the next.
class InsetTracer {
  public:
    /// The sides go counter-clockwise around the bubble, each of them beginning where the last
    /// ended; none has a zero chord. distance > 0, in pixels. The result is valid until the next
    /// call.
    const ArcLoops& trace(std::span<const SideArc> sides, double distance);

    /// The same of a region with several boundaries, each with the region on its left, as of what
    /// lies around a patch: `loop_ends` are one past the last side of each. Loops around what is
    /// left out of an unbounded region go clockwise.
    const ArcLoops& trace(std::span<const SideArc> sides,
                          std::span<const std::size_t> loop_ends,
                          double distance);

  private:
    struct Offset {
        SideArc arc;
        std::size_t side = 0;  // whose offset it is; kCorner for a circle around a corner
    };
    struct Piece {
        std::size_t offset = 0;
        double from = 0.0;  // parameters on it
        double to = 0.0;
        Vec2 tail{0.0, 0.0};
        Vec2 head{0.0, 0.0};
        bool linked = false;
    };

    void begin();
    void collect_offsets(std::span<const SideArc> loop, std::size_t first_side);
    void collect_cuts(const Offset& offset);
    void collect_nearby(const Offset& offset);
    void collect_pieces(std::size_t index);
    bool keeps_distance(const Vec2& point) const;
    Piece* successor(const Piece& piece, const Piece& first);
    void link_loop(Piece& first);

    std::span<const SideArc> sides_;
    double distance_ = 0.0;
    std::vector<Offset> offsets_;
    std::vector<double> cuts_;         // parameters along one offset
    std::vector<std::size_t> nearby_;  // sides that may come too near to one offset
    std::vector<Piece> pieces_;
    ArcLoops loops_;
};

}  // namespace foam::texgen
