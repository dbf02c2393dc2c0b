// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/manifest/manifest.h"
#include "texgen/sheet/layout.h"

#include <filesystem>
#include <string>
#include <vector>

namespace foam::texgen {

/// The content and the layout of a flipbook. The options never change the value of a sample.
struct FlipbookOptions {
    std::vector<std::string> maps = {};  // empty for all maps of the set
    std::vector<int> frames = {};        // in this order; empty for all frames of the set
    int columns = 0;                     // 0 for near_square_columns
    int gutter = 0;                      // pixels around each frame
    /// True for a strip: one column without gutters. Importers of texture arrays and volumes expect
    /// this form. They need no gutter, because they sample each frame as a texture of its own.
    bool strip = false;
};

/// The result of write_flipbook.
struct Flipbook {
    std::vector<std::filesystem::path> files;  // one image per map, then the JSON file
    SheetLayout layout;                        // the layout of all images
};

/// Writes a flipbook of a baked set into the folder `to`, which is created if needed. Each map
/// becomes an image {preset}_sheet_{map} or {preset}_strip_{map} in the format of the set's files.
/// {preset}_sheet.json or {preset}_strip.json describes the images (flipbook_json.h). `folder` is
/// the folder of the manifest. Throws std::invalid_argument for a strip with a gutter or several
/// columns, and the exceptions of map_sequence, check_layout and write_sheet.
Flipbook write_flipbook(const BakedSet& set,
                        const std::filesystem::path& folder,
                        const FlipbookOptions& options,
                        const std::filesystem::path& to);

}  // namespace foam::texgen
