#pragma once

#include "texgen/sheet/layout.h"
#include "texgen/sheet/map_sequence.h"

#include <filesystem>

namespace foam::texgen {

/// Reads the frames of a map and writes them as one image of the same format: the same samples in
/// every bit, with the metadata of the first frame. Cells without a frame are 0. Gutters of frames
/// that tile repeat the other side of the frame, others repeat the pixel at its edge. The sheet
/// holds this one map, in no layer. Keeps the sheet, one frame, and the encoded file in memory.
/// Throws InputError for a file that differs from the manifest or the first frame, and OutputError.
void write_sheet(const MapSequence& sequence,
                 const SheetLayout& layout,
                 const std::filesystem::path& path);

}  // namespace foam::texgen
