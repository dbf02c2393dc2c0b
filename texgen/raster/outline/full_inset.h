#pragma once

#include "texgen/raster/arcs/pixel_arc.h"
#include "texgen/raster/outline/offset_arc.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace foam::texgen {

/// Pieces of offsets that are shorter are left out; pixels. A longer piece is long enough that its
/// middle, in front of a side that leans on it, is seen to be too near.
inline constexpr double kShortestPiece = 1e-6;

/// Finds the inset of a loop of which every side shows, as of most bubbles: the offset of each side
/// is then cut only by those of its neighbors. Bounds of the distances of all pieces from all sides
/// prove that in a few vector operations.
///
/// Buffers are reused between loops.
class FullInset {
  public:
    /// Appends the inset of a loop of sides, which have the region on their left. Returns false and
    /// appends nothing if it is not proven that every side shows. Precondition: distance > 0.
    bool trace(std::span<const OffsetArc> sides, double distance, ArcLoops& loops);

  private:
    struct Offset {
        OffsetArc arc;
        double from = 0.0;  // parameters where the neighbors cut it off
        double to = 0.0;
    };

    // Several sides, with the indices of their own piece and of those beside it.
    static constexpr std::size_t kLanes = 8;
    struct alignas(64) SideLanes {
        std::array<double, kLanes> x, y, along_x, along_y, curvature;  // the middles
        std::array<std::int64_t, kLanes> side, before, after;

        void set(std::size_t lane, std::span<const OffsetArc> sides, std::size_t index);
    };

    bool cut_by_neighbors();
    bool cut_corner(std::size_t before, std::size_t after);
    void place_lanes();
    bool pieces_keep_clear();
    std::int64_t pieces_too_near(const SideLanes& sides) const;
    void append_to(ArcLoops& loops) const;

    std::span<const OffsetArc> sides_;
    double distance_ = 0.0;
    std::vector<Offset> offsets_;
    std::vector<Vec2> points_;  // the tail of each piece, and the first one again
    std::vector<SideLanes> lanes_;
};

}  // namespace foam::texgen
