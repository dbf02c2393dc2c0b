#pragma once

#include "texgen/raster/cell_mask.h"
#include "texgen/raster/snapped_arc.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace foam::texgen {

/// Finds where the arcs around a region cross the middles of rows, to the nearest subpixel. What is
/// found depends on each arc alone: regions on both its sides, and copies of it that whole
/// subpixels moved, agree. Keeps its memory from one region to the next.
class RowCrossings {
  public:
    /// An arc, relative to the lower left corner of the mask that it will be marked in.
    void add(const SnappedArc& arc, const CellMask& mask);

    /// Marks the crossings of all arcs since the last time in the mask, and closes it.
    void mark(CellMask& mask);

  private:
    // The crossings of an arc that rises, with neighbouring rows; relative to its tail.
    struct Rising {
        double half_x;
        double half_y;
        double sine;
        double bulge;
        double across;
        double up;
        double y;        // of the first
        std::int32_t x;  // of the tail
        int row;
        std::size_t first;  // of xs_
        std::size_t count;
    };

    void add_rising(const SnappedArc& arc, const CellMask& mask);
    static void find(std::span<const Rising> arcs, std::int32_t* xs);

    std::vector<Rising> arcs_;
    std::vector<std::int32_t> xs_;
    std::size_t count_ = 0;  // of xs_, in whole vectors
};

}  // namespace foam::texgen
