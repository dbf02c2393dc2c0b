// SPDX-License-Identifier: Apache-2.0

#include "texgen/preset/output_options.h"

#include "texgen/keys/value_kinds.h"

namespace foam::texgen {

namespace {

Keys<OutputOptions> file_keys() {
    constexpr Choices<FileTexts> kTexts = {
        {{{"written", FileTexts::Written}, {"left-out", FileTexts::LeftOut}}}};
    constexpr Choices<Compression, 3> kCompressions = {{{{"fast", Compression::Fast},
                                                         {"small", Compression::Small},
                                                         {"none", Compression::None}}}};
    return {key("pattern",
                Text{},
                "file names: {preset} and {map} are replaced, #### is the frame number, and the "
                "suffix decides the format; an EXR without {map} has all maps as layers",
                &OutputOptions::pattern),
            key("texts",
                kTexts,
                "whether files contain the program version, seed and preset as text",
                &OutputOptions::texts),
            key("frames_per_second",
                Integers{1, 1000},
                "frame rate of the animation, stored in EXR files and in manifest.json",
                &OutputOptions::frames_per_second)
                .in("frames per second"),
            key("png_compression",
                kCompressions,
                "compression of PNG files; small takes ten times as long and makes files a tenth "
                "smaller",
                &OutputOptions::png_compression)
                .used_with("output.pattern", {"*.png"})};
}

Keys<OutputOptions> exr_keys() {
    constexpr Choices<ExrCompression, 5> kCompressions = {{{{"zip", ExrCompression::Zip},
                                                            {"zips", ExrCompression::Zips},
                                                            {"piz", ExrCompression::Piz},
                                                            {"rle", ExrCompression::Rle},
                                                            {"none", ExrCompression::None}}}};
    constexpr Choices<SampleType> kNumbers = {
        {{{"float", SampleType::Float}, {"half", SampleType::Half}}}};
    constexpr Choices<ExrLayout> kLayouts = {
        {{{"rows", ExrLayout::Rows}, {"mip-levels", ExrLayout::MipLevels}}}};
    return {key("exr_compression",
                kCompressions,
                "compression of EXR files; all choices are lossless",
                &OutputOptions::exr_compression)
                .used_with("output.pattern", {"*.exr"}),
            key("exr_level",
                Integers{1, 9},
                "compression level of zip and zips; 1 is fastest, 9 is smallest",
                &OutputOptions::exr_level)
                .used_with("output.exr_compression", {"zip", "zips"}),
            key("exr_numbers",
                kNumbers,
                "type of numbers in EXR files; half has 11 bits of precision and a largest number "
                "of 65504",
                &OutputOptions::exr_numbers)
                .used_with("output.pattern", {"*.exr"}),
            key("exr_layout",
                kLayouts,
                "layout of EXR files: rows, or tiles of 64 x 64 pixels with mip levels",
                &OutputOptions::exr_layout)
                .used_with("output.pattern", {"*.exr"})};
}

}  // namespace

Keys<OutputOptions> output_keys() {
    return joined({file_keys(), exr_keys()});
}

}  // namespace foam::texgen
