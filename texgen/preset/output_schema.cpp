#include "texgen/preset/output_schema.h"

#include "texgen/preset/value_kinds.h"
#include "texgen/preset/key_of_member.h"

namespace foam::texgen {

namespace {

constexpr Choices<Compression, 3> kPngCompressions = {
    {{{"fast", Compression::Fast}, {"small", Compression::Small}, {"none", Compression::None}}}};
constexpr Choices<ExrCompression, 5> kExrCompressions = {{{{"zip", ExrCompression::Zip},
                                                           {"zips", ExrCompression::Zips},
                                                           {"piz", ExrCompression::Piz},
                                                           {"rle", ExrCompression::Rle},
                                                           {"none", ExrCompression::None}}}};
constexpr Choices<ExrType> kExrNumbers = {{{{"float", ExrType::Float}, {"half", ExrType::Half}}}};
constexpr Choices<ExrLayout> kExrLayouts = {
    {{{"rows", ExrLayout::Rows}, {"mip-levels", ExrLayout::MipLevels}}}};
constexpr Choices<FileTexts> kFileTexts = {
    {{{"written", FileTexts::Written}, {"left-out", FileTexts::LeftOut}}}};
constexpr int kHighestRate = 1000;

using P = Preset;
using Options = OutputOptions;

std::vector<Key> exr_keys() {
    return {key("output.exr_compression",
                kExrCompressions,
                "of EXR; all of these keep every bit",
                &P::output,
                &Options::exr_compression),
            key("output.exr_level",
                Integers{1, 9},
                "how hard zip and zips try; 1 is fast, 9 small",
                &P::output,
                &Options::exr_level),
            key("output.exr_numbers",
                kExrNumbers,
                "what EXR stores numbers as; half holds up to 65504, to 11 bits",
                &P::output,
                &Options::exr_numbers),
            key("output.exr_layout",
                kExrLayouts,
                "rows, or tiles of 64 x 64 in mip levels",
                &P::output,
                &Options::exr_layout)};
}

}  // namespace

std::vector<Key> output_keys() {
    std::vector<Key> keys = {
        key("output.pattern",
            Text{},
            "file names: {preset} and {map} are filled in, #### is the frame; .png, or .exr, which "
            "without {map} holds all maps",
            &P::output,
            &Options::pattern),
        key("output.texts",
            kFileTexts,
            "whether files tell of their version, seed and preset",
            &P::output,
            &Options::texts),
        key("output.frames_per_second",
            Integers{1, kHighestRate},
            "what EXR says of the speed",
            &P::output,
            &Options::frames_per_second),
        key("output.png_compression",
            kPngCompressions,
            "of PNG; small takes ten times as long for a tenth less",
            &P::output,
            &Options::png_compression)};
    for (const Key& key : exr_keys()) {
        keys.push_back(key);
    }
    return keys;
}

}  // namespace foam::texgen
