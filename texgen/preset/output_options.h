#pragma once

#include "texgen/image/deflate.h"
#include "texgen/image/exr.h"
#include "texgen/keys/key.h"

#include <string>

namespace foam::texgen {

/// The presence of texts in files about how they were made.
enum class FileTexts { Written, LeftOut };

/// The order of the pixels in an EXR file.
enum class ExrLayout { Rows, MipLevels };

/// The names and the form of image files. None of it changes a pixel.
struct OutputOptions {
    std::string pattern = "out/{preset}_{map}.####.png";  // see FilePattern
    FileTexts texts = FileTexts::Written;
    int frames_per_second = 24;  // as an EXR states
    Compression png_compression = Compression::Fast;
    ExrCompression exr_compression = ExrCompression::Zip;
    int exr_level = 2;                           // of zip and zips, 1 to 9
    SampleType exr_numbers = SampleType::Float;  // or Half
    ExrLayout exr_layout = ExrLayout::Rows;
};

Keys<OutputOptions> output_keys();

}  // namespace foam::texgen
