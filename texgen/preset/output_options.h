// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/image/deflate.h"
#include "texgen/image/exr.h"
#include "texgen/keys/key.h"

#include <string>

namespace foam::texgen {

/// Selects whether image files contain the program version, the seed and the preset as text.
enum class FileTexts { Written, LeftOut };

/// The order of the pixels in an EXR file.
enum class ExrLayout { Rows, MipLevels };

/// The names and the encoding of image files. These options do not change the drawing. Half floats
/// in EXR files round its numbers.
struct OutputOptions {
    std::string pattern = "out/{preset}_{map}.####.png";  // see FilePattern
    FileTexts texts = FileTexts::Written;
    int frames_per_second = 24;  // stored in EXR files
    Compression png_compression = Compression::Fast;
    ExrCompression exr_compression = ExrCompression::Zip;
    int exr_level = 2;                           // compression level of zip and zips, 1 to 9
    SampleType exr_numbers = SampleType::Float;  // Float or Half
    ExrLayout exr_layout = ExrLayout::Rows;
};

Keys<OutputOptions> output_keys();

}  // namespace foam::texgen
