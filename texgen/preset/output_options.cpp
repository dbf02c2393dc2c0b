// SPDX-License-Identifier: Apache-2.0

#include "texgen/preset/output_options.h"

#include "texgen/keys/value_kinds.h"

namespace foam::texgen {

namespace {

using Options = OutputOptions;

Keys<OutputOptions> file_keys() {
    constexpr Choices<FileTexts> kTexts = {
        {{{"written", FileTexts::Written}, {"left-out", FileTexts::LeftOut}}}};
    constexpr Choices<Compression, 3> kCompressions = {{{{"fast", Compression::Fast},
                                                         {"small", Compression::Small},
                                                         {"none", Compression::None}}}};
    return {key("pattern",
                Text{},
                "file names: {preset} and {map} are filled in, #### is the frame, and the suffix "
                "decides the format; an EXR without {map} holds all maps",
                &Options::pattern),
            key("texts",
                kTexts,
                "whether files tell of their version, seed and preset",
                &Options::texts),
            key("frames_per_second",
                Integers{1, 1000},
                "what EXR says of the speed",
                &Options::frames_per_second),
            key("png_compression",
                kCompressions,
                "of PNG; small takes ten times as long for a tenth less",
                &Options::png_compression)};
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
                "of EXR; all of these keep every bit",
                &Options::exr_compression),
            key("exr_level",
                Integers{1, 9},
                "how hard zip and zips try; 1 is fast, 9 small",
                &Options::exr_level),
            key("exr_numbers",
                kNumbers,
                "what EXR stores numbers as; half holds up to 65504, to 11 bits",
                &Options::exr_numbers),
            key("exr_layout",
                kLayouts,
                "rows, or tiles of 64 x 64 in mip levels",
                &Options::exr_layout)};
}

}  // namespace

Keys<OutputOptions> output_keys() {
    return joined({file_keys(), exr_keys()});
}

}  // namespace foam::texgen
