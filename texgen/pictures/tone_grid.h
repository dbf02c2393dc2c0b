// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/pictures/source_picture.h"

#include <cstddef>
#include <vector>

namespace foam::texgen {

/// Tones from 0 (light) to 1 (dark) on a grid, in rows from bottom to top.
struct ToneGrid {
    int columns = 0;
    int rows = 0;
    std::vector<double> tones{};

    ToneGrid(int columns_, int rows_)
        : columns(columns_),
          rows(rows_),
          tones(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_)) {}

    double& at(int column, int row) { return tones[index(column, row)]; }
    double at(int column, int row) const { return tones[index(column, row)]; }

  private:
    std::size_t index(int column, int row) const {
        return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns) +
               static_cast<std::size_t>(column);
    }
};

/// Returns the darkness of a picture: 1 - luminance_of its colors on white. Light is averaged over
/// the pixels of each cell, if the picture has more than `most_cells` columns or rows.
ToneGrid darkness_of(const SourcePicture& picture, int most_cells);

/// Stretches the tones to the range from 0 to 1. Equal tones become 0.
void stretch_tones(ToneGrid& grid);

/// Returns the grid with mirror images of it beside, above, and beside and above it.
ToneGrid mirrored(const ToneGrid& grid);

/// Adjusts the tones at each edge and at the opposite one to their mean. The adjustment fades out
/// over an eighth of the grid.
void blend_edges(ToneGrid& grid);

/// Returns true if opposite edges differ so much that a tiled picture shows them: if the mean
/// difference of their tones is above 0.02 and above three times the mean difference of adjacent
/// tones in this direction.
bool has_visible_edges(const ToneGrid& grid);

}  // namespace foam::texgen
