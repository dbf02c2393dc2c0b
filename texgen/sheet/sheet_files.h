// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/sheet/layout.h"
#include "texgen/sheet/map_sequence.h"

#include <filesystem>

namespace foam::texgen {

/// Reads the frames of a map and writes them as one image of the same format. Samples are copied to
/// the bit, and the metadata are those of the first frame. Cells without a frame are 0. The gutter
/// of a frame that tiles repeats the opposite side of the frame; other gutters repeat the pixels at
/// its edge. The sheet contains only this map, without a layer. The sheet, one frame and the
/// encoded file are in memory at the same time. Throws InputError for a file that cannot be read,
/// differs in size from the layout or in channels from the first frame. Throws OutputError if the
/// sheet cannot be written, and as check_layout does.
void write_sheet(const MapSequence& sequence,
                 const SheetLayout& layout,
                 const std::filesystem::path& path);

}  // namespace foam::texgen
