#pragma once

#include "texgen/raster/row_crossings.h"

#include <vector>

namespace foam::test {

/// The pixels that arcs go around, as a mask of these columns and rows; the first rows stay unused.
inline texgen::CellMask mask_of(const std::vector<texgen::SnappedArc>& arcs,
                                int columns,
                                int rows,
                                int unused_rows = 0) {
    texgen::CellMask mask;
    mask.reset(columns, rows, unused_rows);
    texgen::RowCrossings crossings;
    for (const texgen::SnappedArc& arc : arcs) {
        crossings.add(arc, mask);
    }
    crossings.mark(mask);
    return mask;
}

}  // namespace foam::test
