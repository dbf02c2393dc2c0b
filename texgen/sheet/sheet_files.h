// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/sheet/layout.h"
#include "texgen/sheet/map_sequence.h"

#include <filesystem>

namespace foam::texgen {

/// Reads the frames of a map and writes them as one image of the same format. Samples are copied
/// without any change. The metadata are copied from the first frame, but the sheet is
/// not periodic. If they have texts, a text with the layout is added. Cells without a frame are 0.
/// The gutter of a frame that tiles repeats the opposite side of the frame; other gutters repeat
/// the pixels at its edge. The sheet contains only this map, and its channel names have no layer.
/// The whole sheet is in memory together with one frame, and then with the encoded file.
///
/// Throws InputError if a file cannot be read, if its size differs from the layout, or if its
/// channels differ from the first frame. Throws OutputError if the sheet cannot be written, and the
/// exceptions of check_layout.
void write_sheet(const MapSequence& sequence,
                 const SheetLayout& layout,
                 const std::filesystem::path& path);

}  // namespace foam::texgen
