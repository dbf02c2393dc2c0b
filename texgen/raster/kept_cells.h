#pragma once

#include "texgen/raster/cell_group.h"

#include <cstddef>
#include <span>
#include <vector>

namespace foam::texgen {

/// Cells that were gone around, and are needed when their group has begun anew.
class KeptCells {
  public:
    void add(const TorusCell& cell) {
        cells_.push_back(cell);
        lanes_.insert(lanes_.end(), cell.sides.lanes.begin(), cell.sides.lanes.end());
    }

    /// Calls visit(cell) for all of them, in their order; their sides stand until one is added.
    template <class Visit>
    void visit(const Visit& visit) const {
        std::size_t first = 0;
        for (TorusCell cell : cells_) {
            const std::size_t count = cell.sides.lanes.size();
            cell.sides.lanes = std::span(lanes_).subspan(first, count);
            first += count;
            visit(cell);
        }
    }

  private:
    std::vector<TorusCell> cells_;
    std::vector<SideLanes> lanes_;
};

}  // namespace foam::texgen
