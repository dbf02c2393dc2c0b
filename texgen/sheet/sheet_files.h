#pragma once

#include "texgen/sheet/layout.h"
#include "texgen/sheet/map_sequence.h"
#include "texgen/sheet/place_frame.h"

#include <filesystem>
#include <string>

namespace foam::texgen {

/// Reads the frames of a map and writes them as one image of the same format, PNG or EXR: the same
/// samples in every bit, with what the first frame's file says of them. Cells without a frame are
/// 0. Frames that tile go on in their gutters, others keep the pixel at their edge. The sheet of an
/// EXR holds this one map, in no layer. Holds the sheet, one frame, and the sheet's file in memory.
/// Throws InputError for a file that is not what the manifest and the first frame say, OutputError.
void write_sheet(const MapSequence& sequence,
                 const SheetLayout& layout,
                 const std::filesystem::path& path);

/// Its two halves.
void write_png_sheet(const MapSequence& sequence,
                     const SheetLayout& layout,
                     const std::filesystem::path& path);
void write_exr_sheet(const MapSequence& sequence,
                     const SheetLayout& layout,
                     const std::filesystem::path& path);

/// "8 x 6 frames of 128 x 128, gutter 4": in the texts of a sheet, if its frames have any.
std::string text_of(const SheetLayout& layout);

/// Throws InputError, in the name of the file, unless a frame has these extents.
void check_extents(const MapFile& file, const SheetLayout& layout, int width, int height);

inline Gutter gutter_of(const MapFile& file) {
    return file.tiles ? Gutter::Periodic : Gutter::Edge;
}

}  // namespace foam::texgen
