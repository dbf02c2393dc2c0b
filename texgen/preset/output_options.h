// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/image/deflate.h"
#include "texgen/image/exr.h"
#include "texgen/keys/key.h"

#include <string>

namespace foam::texgen {

/// Selects whether image files contain the program version, the seed and the preset as texts.
enum class FileTexts { Written, LeftOut };

/// The order of the pixels in an EXR file: rows of the full image, or tiles of all mip levels.
enum class ExrLayout { Rows, MipLevels };

/// The names and the encoding of image files. These options do not change what is drawn. However,
/// `exr_numbers` = Half rounds the numbers in EXR files.
struct OutputOptions {
    std::string pattern = "out/{preset}_{map}.####.png";  // see FilePattern (bake/file_pattern.h)
    FileTexts texts = FileTexts::Written;
    int frames_per_second = 24;  // stored in EXR files and in manifest.json
    Compression png_compression = Compression::Fast;
    ExrCompression exr_compression = ExrCompression::Zip;
    // The compression level of Zip and Zips: 1 is the fastest, 9 gives the smallest files.
    int exr_level = 2;
    SampleType exr_numbers = SampleType::Float;  // Float or Half; colors are always Half
    ExrLayout exr_layout = ExrLayout::Rows;
};

Keys<OutputOptions> output_keys();

}  // namespace foam::texgen
