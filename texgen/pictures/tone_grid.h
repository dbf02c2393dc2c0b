// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/image/image.h"
#include "texgen/pictures/source_picture.h"

namespace foam::texgen {

/// A grid of tones from 0 (light) to 1 (dark), as an image with one channel.
using ToneGrid = Image<double>;

/// Returns the darkness of a picture: 1 minus the luminance (luminance_of) of its colors on white.
/// The grid has a cell for each pixel. If the picture has more than `max_cells` columns or rows,
/// the grid has only this many cells along its longer side. Each cell then has the mean darkness of
/// its pixels.
ToneGrid darkness_of(const SourcePicture& picture, int max_cells);

/// Stretches the tones to the range from 0 to 1. If all tones are equal, they become 0.
void stretch_tones(ToneGrid& grid);

/// Returns a grid of twice the width and height: the given grid at the lower left, and mirror
/// images of it to the right, above, and at the upper right.
ToneGrid mirrored(const ToneGrid& grid);

/// Makes opposite edges equal: in each row and each column, the first and the last tone both become
/// their mean. The adjustment fades out over an eighth of the grid.
void blend_edges(ToneGrid& grid);

/// Returns true if opposite edges differ so much that a tiled picture shows them. The mean
/// difference of their tones must be above 0.02. It must also be above three times the mean
/// difference of adjacent tones along the lines from edge to edge.
bool has_visible_edges(const ToneGrid& grid);

}  // namespace foam::texgen
