// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/image/image.h"
#include "texgen/sheet/layout.h"

namespace foam::texgen {

/// The content of a gutter, the border around a frame in a sheet: the periodic continuation of the
/// frame, or copies of its edge pixels.
enum class Gutter { Periodic, Edge };

/// Copies a frame into a cell of a sheet and fills the gutter around the frame. `number` is the
/// number of the cell; cells are numbered from 0 in the order of the layout. Samples are integers
/// of 8, 16 or 32 bits, or floats. Precondition: frame and sheet have the same number of channels,
/// and their sizes agree with the layout.
template <class Sample>
void place_frame(ImageView<Sample> sheet,
                 const SheetLayout& layout,
                 int number,
                 ImageView<const Sample> frame,
                 Gutter gutter);

}  // namespace foam::texgen
