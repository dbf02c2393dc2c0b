// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/files/file_io.h"
#include "texgen/animation/progress_meter.h"
#include "texgen/sheet/layout.h"
#include "texgen/sheet/map_sequence.h"

#include <filesystem>

namespace foam::texgen {

/// Reads the frames of a map, joins them into one image of the same format, and stages this image.
/// A staged file (StagedFile) has its content, but not yet its name, so that the caller can publish
/// all sheets at once. `path` ends in the suffix of the format. Samples are copied without any
/// change. The metadata are copied from the first frame, but the sheet is marked as not periodic.
/// If the metadata contain texts, a text with the layout is added. Samples in cells without a frame
/// are 0. The gutter is the border around each frame. If a frame tiles, its gutter contains the
/// periodic continuation of the frame; otherwise, the gutter repeats the pixels at the edge of the
/// frame. An EXR file of a frame may contain several maps, each as a layer. The sheet contains only
/// this map, and its channel names have no layer. While the sheet is composed, the memory contains
/// the whole sheet and one frame. While the sheet is written, the memory contains the whole sheet
/// and the encoded file. `progress` counts each frame; the last frame is counted when the sheet has
/// been staged. Precondition: the sequence has layout.frames files.
///
/// Throws InputError if a file cannot be read or lacks the layer of the map. Also throws InputError
/// if the width or height of its image differs from the frame size of the layout, or if its
/// channels differ from the channels of the first frame. Throws OutputError if the sheet cannot be
/// written. Also throws the exceptions of check_layout.
StagedFile stage_sheet(const MapSequence& sequence,
                       const SheetLayout& layout,
                       const std::filesystem::path& path,
                       ProgressMeter& progress);

}  // namespace foam::texgen
