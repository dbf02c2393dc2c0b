// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/animation/progress.h"
#include "texgen/manifest/manifest.h"
#include "texgen/sheet/layout.h"

#include <filesystem>
#include <string>
#include <vector>

namespace foam::texgen {

/// The content and the layout of a flipbook. A flipbook consists of sheets and of a JSON file
/// that describes them. There is one sheet per map: an image that contains frames of the map. No
/// option changes the value of a sample.
struct FlipbookOptions {
    std::vector<std::string> maps = {};  // empty for all maps of the set
    std::vector<int> frames = {};        // frame numbers, in this order; empty for all of the set
    int columns = 0;                     // 0: the result of near_square_columns
    int gutter = 0;                      // width of the border around each frame, pixels
    /// True for a strip: one column without gutters. Programs that import texture arrays or volumes
    /// expect a strip. No gutter is needed, because each frame becomes a separate layer of the
    /// texture.
    bool strip = false;
};

/// The result of write_flipbook.
struct Flipbook {
    std::vector<std::filesystem::path> files;  // one image per map, then the JSON file
    SheetLayout layout;                        // the layout of all images
    // The names of images of an earlier flipbook that the JSON file listed and that do not belong
    // to this flipbook.
    std::vector<std::string> unlisted;
};

/// Writes a flipbook of a baked set into the folder `to`. The folder is created if needed. Each map
/// becomes an image {preset}_sheet_{map} or {preset}_strip_{map} in the format of the set's files.
/// {preset}_sheet.json or {preset}_strip.json describes these images (flipbook_json.h), and the
/// images of other maps that it already lists, if they belong to an earlier flipbook of the same
/// frames and layout (keep_earlier_sheets). `folder` is the folder of the manifest. `on_progress`
/// receives the phase Sheets. If an exception is thrown before the last sheet is complete, there is
/// no new file. Throws std::invalid_argument if a strip has a gutter or several columns. Also
/// throws the exceptions of map_sequence, check_layout, stage_sheet and keep_earlier_sheets, and
/// OutputError if the JSON file cannot be written.
Flipbook write_flipbook(const BakedSet& set,
                        const std::filesystem::path& folder,
                        const FlipbookOptions& options,
                        const std::filesystem::path& to,
                        const ProgressCallback& on_progress = {});

}  // namespace foam::texgen
