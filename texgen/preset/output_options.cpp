// SPDX-License-Identifier: Apache-2.0

#include "texgen/preset/output_options.h"

#include "texgen/keys/parsed_texts.h"
#include "texgen/keys/value_kinds.h"
#include "texgen/maps/all_maps.h"
#include "texgen/maps/packing.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <stdexcept>

namespace foam::texgen {

namespace {

Keys<OutputOptions> name_keys() {
    return {
        key("pack",
            ParsedTexts<parse_packing>{"a list of packings NAME=R,G,B or NAME=R,G,B,A, such as "
                                       "\"ORM=occlusion,roughness,metallic\""},
            "packed images, drawn besides image.maps: each channel is a map (roughness), 1 minus a "
            "map (1-roughness), a channel of a map (normal.X), or a constant from 0 to 1; "
            "NAME:16= gives 16 bits per sample",
            &OutputOptions::pack),
        key("names",
            ParsedTexts<parse_named_map>{"a list of words for maps, such as \"albedo=BaseColor\""},
            "words that replace the names of maps in file names ({map})",
            &OutputOptions::names)};
}

Keys<OutputOptions> file_keys() {
    constexpr Choices<FileTexts> kTexts = {
        {{{"written", FileTexts::Written}, {"left-out", FileTexts::LeftOut}}}};
    constexpr Choices<Compression, 3> kCompressions = {{{{"fast", Compression::Fast},
                                                         {"small", Compression::Small},
                                                         {"none", Compression::None}}}};
    return {key("pattern",
                Text{},
                "file names: {preset}, {map}, {seed}, {size} and keys such as {foam.bubbles} are "
                "replaced, #### is the frame number, and the suffix decides the format; an EXR "
                "without {map} has all maps as layers; .svg, .dxf and .pdf are drawings (keys "
                "vector.*), .stl and .glb are meshes (keys mesh.*), .csv and .json are tables of "
                "the foam",
                &OutputOptions::pattern),
            key("texts",
                kTexts,
                "whether files contain the program version, seed and preset as text",
                &OutputOptions::texts),
            key("frames_per_second",
                Integers{1, 1000},
                "frame rate of the animation; it is stored in EXR files and in manifest.json, and "
                "previews, sheets and scene files use it, too",
                &OutputOptions::frames_per_second)
                .in("frames per second"),
            key("png_compression",
                kCompressions,
                "compression of PNG files; with small, files are a tenth smaller than with fast, "
                "but compression takes ten times as long",
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
    constexpr Choices<Primaries> kPrimaries = {
        {{{"srgb", Primaries::Srgb}, {"acescg", Primaries::AcesCg}}}};
    return {key("primaries",
                kPrimaries,
                "primaries and white point of colors in EXR files: those of sRGB, or those of "
                "ACEScg (AP1), to which colors are then converted; data stay the same",
                &OutputOptions::primaries)
                .only_for("output.pattern", {"*.exr"}),
            key("exr_compression",
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

// The kind of values of output.sheet_pattern: paths of files whose names contain {map}.
struct SheetPatterns {
    std::string allowed() const {
        return "a path without suffix whose file name contains {map}, such as "
               "\"out/{preset}_sheet_{map}\"";
    }
    std::string schema() const { return R"({"type": "string", "pattern": "\\{map\\}[^/]*$"})"; }
    bool read(const Value& value, std::string& member) const {
        std::string text;
        const bool allowed = Text{}.read(value, text) &&
                             text.find("{map}", text.find_last_of('/') + 1) != std::string::npos;
        member = allowed ? text : member;
        return allowed;
    }
    Value write(const std::string& member) const { return {member}; }
};

Keys<OutputOptions> sheet_keys() {
    constexpr Choices<SheetKind, 5> kKinds = {{{{"none", SheetKind::None},
                                                {"grid", SheetKind::Grid},
                                                {"strip", SheetKind::Strip},
                                                {"dds", SheetKind::Dds},
                                                {"ktx2", SheetKind::Ktx2}}}};
    return {key("sheets",
                kKinds,
                "files to which the commands bake and render join their frames: sheets with the "
                "frames in rows (grid) or in one column (strip), or array textures (dds, ktx2)",
                &OutputOptions::sheets),
            key("sheet_pattern",
                SheetPatterns{},
                "paths of the sheets of output.sheets, without suffix, with the placeholders of "
                "output.pattern; if a path begins with out/, the option --out replaces out/ by the "
                "folder of the images",
                &OutputOptions::sheet_pattern)
                .unused_with("output.sheets", {"none"})};
}

constexpr std::array<std::string_view, 3> kSceneFormats = {"usda", "mtlx", "gltf"};

constexpr std::array<std::string_view, 3> kMeasurements = {"bubbles", "events", "shear_modulus"};

// The kind of values that are lists of words, in which no word occurs twice. The list may be empty.
// A single word may be written without brackets.
struct WordListsOrNone {
    WordLists word_lists;

    explicit WordListsOrNone(std::span<const std::string_view> words) : word_lists{words} {}

    std::span<const std::string_view> words() const { return word_lists.words(); }
    std::string allowed() const { return word_lists.allowed() + ", or []"; }
    std::string schema() const {
        return any_of_schema(word_lists.schema(), R"({"type": "array", "maxItems": 0})");
    }
    bool read(const Value& value, std::vector<std::string>& member) const {
        const auto* const list = std::get_if<Value::List>(&value.data);
        if (list != nullptr && list->empty()) {
            member.clear();
            return true;
        }
        return word_lists.read(value, member);
    }
    Value write(const std::vector<std::string>& member) const { return word_lists.write(member); }
};

Keys<OutputOptions> scene_keys() {
    return {key("scene",
                WordListsOrNone(kSceneFormats),
                "scene files of the material, which bake and render write beside manifest.json: "
                "OpenUSD (usda), MaterialX (mtlx), and a preview of the first frame (gltf)",
                &OutputOptions::scene)};
}

Keys<OutputOptions> measurement_keys() {
    return {
        key("measurements",
            WordListsOrNone(kMeasurements),
            "what manifest.json also lists for each frame: the shapes of all bubbles (bubbles), "
            "all T1s, T2s and births (events), and the shear modulus (shear_modulus), which takes "
            "about as long as a time step",
            &OutputOptions::measurements)};
}

Keys<OutputOptions> texture_keys() {
    constexpr Choices<BlockCompression> kBlocks = {
        {{{"auto", BlockCompression::Auto}, {"none", BlockCompression::None}}}};
    constexpr Choices<bool> kSwitch = {{{{"on", true}, {"off", false}}}};
    return {key("block_compression",
                kBlocks,
                "block compression of DDS and KTX2 files: auto compresses images of 8 bits, except "
                "ids, with a small loss, if width and height are multiples of 4; with none, all "
                "samples are stored exactly",
                &OutputOptions::block_compression)
                .used_with("output.pattern", {"*.dds", "*.ktx2"}),
            key("mip_levels",
                kSwitch,
                "whether DDS and KTX2 files contain all mip levels",
                &OutputOptions::mip_levels)
                .used_with("output.pattern", {"*.dds", "*.ktx2"})};
}

}  // namespace

std::span<const std::string_view> scene_formats() {
    return kSceneFormats;
}

NamedMap parse_named_map(std::string_view text) {
    const std::size_t equals = text.find('=');
    if (equals == std::string_view::npos) {
        throw std::invalid_argument(
            fmt::format("'{}' must be MAP=WORD, such as albedo=BaseColor", text));
    }
    NamedMap named{std::string(find_map(text.substr(0, equals)).name),
                   std::string(text.substr(equals + 1))};
    if (!is_file_word(named.word)) {
        throw std::invalid_argument(
            fmt::format("'{}': the word must have 1 to {} letters, digits, '_' or '-'",
                        text,
                        kMaxFileWordLength));
    }
    return named;
}

Keys<OutputOptions> output_keys() {
    return joined({file_keys(),
                   name_keys(),
                   sheet_keys(),
                   scene_keys(),
                   measurement_keys(),
                   exr_keys(),
                   texture_keys()});
}

}  // namespace foam::texgen
