// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/image/deflate.h"
#include "texgen/image/exr.h"
#include "texgen/keys/key.h"

#include <string>

namespace foam::texgen {

/// Tells if image files contain texts about how they were made: version, seed and preset.
enum class FileTexts { Written, LeftOut };

/// The order of the pixels in an EXR file.
enum class ExrLayout { Rows, MipLevels };

/// The names and the encoding of image files. None of these options changes what is drawn; half
/// floats in EXR files round numbers.
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
