// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/animation/progress.h"
#include "texgen/manifest/manifest.h"
#include "texgen/preset/preset.h"
#include "texgen/sheet/earlier_sheets.h"
#include "texgen/sheet/layout.h"

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace foam::texgen {

/// The content and the layout of a flipbook. A flipbook consists of sheets and of a JSON file
/// that describes them. There is one sheet per map: an image that contains frames of the map. A
/// sheet contains the pixels of the frames without a change of their values.
struct FlipbookOptions {
    std::vector<std::string> maps = {};  // empty for all maps of the set
    std::vector<int> frames = {};        // frame numbers, in this order; empty for all of the set
    int columns = 0;                     // 0: the result of near_square_columns
    int gutter = 0;                      // width of the border around each frame, pixels
    /// True for a strip: one column without gutters. Programs that import texture arrays or volumes
    /// expect a strip. No gutter is needed, because each frame becomes a separate layer of the
    /// texture.
    bool strip = false;
    /// The suffix of the files of array textures, ".dds" or ".ktx2", or empty for sheets. With a
    /// suffix, array textures are written instead of sheets: each frame is a layer with its mip
    /// levels. A layer can repeat as a tile; a frame in a sheet cannot. For arrays, `gutter` must
    /// be 0 and `columns` at most 1. Frames of PNG files are encoded (array_files.h).
    std::string array_suffix = {};
    /// The names of the files without suffix, in which {preset} and {map} are replaced. If this
    /// text is empty, the name is {preset}_sheet_{map} for a sheet, {preset}_strip_{map} for a
    /// strip, and {preset}_array_{map} for an array. For the name of the JSON file, "_{map}" is
    /// removed; a {map} that does not follow a "_" is replaced by "sheets".
    std::string names = {};
    /// Words that replace the names of maps in file names, by map.
    std::map<std::string, std::string> words = {};
};

/// The result of write_flipbook.
struct Flipbook {
    std::vector<std::filesystem::path> files;  // one image per map, then the JSON file
    SheetLayout layout;                        // the layout of all images
    EarlierSheets earlier;                     // the images that the JSON file listed before
};

/// Writes a flipbook of a baked set into the folder `to`. The folder is created if needed. Each map
/// becomes a sheet or a strip in the format of the set's files, or an array texture with the suffix
/// options.array_suffix. A JSON file describes these images (flipbook_json.h). If an earlier
/// flipbook of the same frames and layout has written the JSON file, the images of other maps that
/// it lists stay listed (keep_earlier_sheets). FlipbookOptions::names explains the file names.
/// `folder` is the folder of the manifest. `on_progress` receives the phase Sheets. If an exception
/// is thrown before all sheets and the JSON file are complete, there is no new file.
/// Throws std::invalid_argument if a strip or an array has a gutter or several columns, and if a
/// sheet would be compressed with a loss (ImageFormat::is_lossy). Also throws the exceptions of
/// map_sequence, check_layout, stage_sheet, stage_array and keep_earlier_sheets, and OutputError if
/// the JSON file cannot be written.
Flipbook write_flipbook(const BakedSet& set,
                        const std::filesystem::path& folder,
                        const FlipbookOptions& options,
                        const std::filesystem::path& to,
                        const ProgressCallback& on_progress = {});

/// Returns a preset whose sheets are written beside its images. The folder of the images replaces
/// the default folder "out/" at the start of output.sheet_pattern. An option that moves the images
/// thus moves the sheets, too. The preset is returned unchanged in these cases:
/// - no sheets are written (output.sheets);
/// - output.sheet_pattern does not begin with "out/";
/// - the file pattern of the images begins with "out/".
///
/// Throws std::invalid_argument if the folder would be replaced, but the file pattern of the images
/// is malformed.
Preset with_sheets_beside_images(Preset preset);

/// Checks the sheets of a preset before a bake. Throws std::invalid_argument if the files of the
/// preset cannot be joined into the images that output.sheets asks for. Also throws
/// std::invalid_argument if a placeholder of output.sheet_pattern is unknown, or if its value
/// cannot be a part of a file name (placeholder_text in preset/placeholder.h). Does nothing if
/// output.sheets is None.
void check_sheets(const Preset& preset);

/// Checks that the sheets of a preset can be written into their folder, before a bake begins.
/// Throws OutputError if not. Does nothing if output.sheets is None. Precondition: check_sheets
/// does not throw.
void check_sheet_folder(const Preset& preset);

/// Joins the frames of the latest bake of a preset, as output.sheets says. Call this function after
/// the bake. `frames` are the numbers of the frames. Throws the exceptions of read_manifest and
/// write_flipbook. Precondition: output.sheets is not None, and check_sheets does not throw.
Flipbook write_sheets(const Preset& preset,
                      std::vector<int> frames,
                      const ProgressCallback& on_progress = {});

}  // namespace foam::texgen
