// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/image/deflate.h"
#include "texgen/image/exr.h"
#include "texgen/image/gpu_texture.h"
#include "texgen/keys/key.h"

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace foam::texgen {

/// Selects whether image files contain the program version, the seed and the preset as texts.
enum class FileTexts { Written, LeftOut };

/// The order of the pixels in an EXR file: rows of the full image, or tiles of all mip levels.
enum class ExrLayout { Rows, MipLevels };

/// The word for a map in file names.
struct NamedMap {
    std::string map;
    std::string word;
};

/// Parses an item of OutputOptions::names, such as "albedo=BaseColor". Throws std::invalid_argument
/// if the text has another form, if the map is unknown, or if the word is not allowed in file names
/// (is_file_word in maps/packing.h).
NamedMap parse_named_map(std::string_view text);

/// The kind of file to which a bake joins its frames after the last frame.
enum class SheetKind {
    None,
    Grid,   // one image per map with all frames in rows
    Strip,  // one image per map with all frames in one column
    Dds,    // one array texture per map, a DDS file
    Ktx2,   // one array texture per map, a KTX2 file
};

/// Returns the formats of scene files, as output.scene names them: "usda", "mtlx" and "gltf".
std::span<const std::string_view> scene_formats();

/// The folder with which the default patterns of images and sheets begin.
inline constexpr std::string_view kDefaultFolder = "out/";

/// The names, the channels and the encoding of image files.
struct OutputOptions {
    std::string pattern = "out/{preset}_{map}.####.png";  // see FilePattern (bake/file_pattern.h)
    std::vector<std::string> pack = {};   // packed images (parse_packing in maps/packing.h)
    std::vector<std::string> names = {};  // words for maps in file names (parse_named_map)
    SheetKind sheets = SheetKind::None;
    // The path of each sheet, without its suffix. {map}, {preset} and so on are replaced as in
    // `pattern`.
    std::string sheet_pattern = "out/{preset}_sheet_{map}";
    std::vector<std::string> scene = {};  // the scene files to write; words of scene_formats()
    // The measurements of each frame that manifest.json also contains: "bubbles", "events" and
    // "shear_modulus" (bake/measurements.h).
    std::vector<std::string> measurements = {};
    FileTexts texts = FileTexts::Written;
    // Stored in EXR files and in manifest.json; previews, sheets and scene files use it, too.
    int frames_per_second = 24;
    Compression png_compression = Compression::Fast;
    ExrCompression exr_compression = ExrCompression::Zip;
    // The compression level of Zip and Zips: 1 is the fastest, 9 gives the smallest files.
    int exr_level = 2;
    SampleType exr_numbers = SampleType::Float;  // Float or Half; colors are always Half
    ExrLayout exr_layout = ExrLayout::Rows;
    Primaries primaries = Primaries::Srgb;  // the primaries of colors in EXR files
    // The next two members apply to frames in DDS and KTX2 files, but not to array textures
    // (SheetKind).
    BlockCompression block_compression = BlockCompression::Auto;
    bool mip_levels = true;
};

/// Returns the keys of the table `output` of a preset, without the prefix "output.".
Keys<OutputOptions> output_keys();

}  // namespace foam::texgen
