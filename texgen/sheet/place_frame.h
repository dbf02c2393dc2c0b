#pragma once

#include "texgen/image/image.h"
#include "texgen/sheet/layout.h"

namespace foam::texgen {

/// What stands in a gutter, as if the frame went on there: round and round, as a tile does, or with
/// the pixel at its edge.
enum class Gutter { Periodic, Edge };

/// Copies a frame into the cell of this number, from 0, of a sheet that is laid out so, and fills
/// the gutter around it. Frame and sheet have the same number of channels. For 8-bit and 16-bit
/// samples, floats and 32-bit integers.
template <class Sample>
void place_frame(ImageView<Sample> sheet,
                 const SheetLayout& layout,
                 int number,
                 ImageView<const Sample> frame,
                 Gutter gutter);

}  // namespace foam::texgen
