#pragma once

#include "texgen/manifest/manifest.h"
#include "texgen/sheet/layout.h"

#include <filesystem>
#include <string>
#include <vector>

namespace foam::texgen {

/// What is made of a baked set. None of it changes a sample.
struct FlipbookOptions {
    std::vector<std::string> maps = {};  // all of the set if there are none
    std::vector<int> frames = {};        // in this order; all of the set if there are none
    int columns = 0;                     // 0: near_square_columns
    int gutter = 0;                      // pixels around each frame
    /// One column, as importers of texture arrays and volumes cut it: its frames wrap around by
    /// themselves, so it has no gutter.
    bool strip = false;
};

struct Flipbook {
    std::vector<std::filesystem::path> files;  // an image a map, then what describes them all
    SheetLayout layout;                        // of every map
};

/// Writes {preset}_sheet_{map}, or {preset}_strip_{map}, in the format of the set's files, and
/// {preset}_sheet.json or {preset}_strip.json (flipbook_json.h) into a folder, made as needed.
/// `folder` is that of the manifest. Throws as map_sequence, check_layout and write_sheet, and
/// std::invalid_argument for a strip with a gutter or of several columns.
Flipbook write_flipbook(const BakedSet& set,
                        const std::filesystem::path& folder,
                        const FlipbookOptions& options,
                        const std::filesystem::path& to);

}  // namespace foam::texgen
