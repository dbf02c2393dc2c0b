// SPDX-License-Identifier: Apache-2.0

#include "texgen/sheet/flipbook.h"

#include "core/files/content_text.h"
#include "core/files/file_io.h"
#include "texgen/animation/progress_meter.h"
#include "texgen/bake/file_pattern.h"
#include "texgen/image/format.h"
#include "texgen/manifest/bake_recorder.h"
#include "texgen/manifest/manifest_file.h"
#include "texgen/preset/drawn_images.h"
#include "texgen/preset/placeholder.h"
#include "texgen/preset/preset_keys.h"
#include "texgen/sheet/array_files.h"
#include "texgen/sheet/earlier_sheets.h"
#include "texgen/sheet/flipbook_json.h"
#include "texgen/sheet/map_sequence.h"
#include "texgen/sheet/sheet_files.h"

#include <fmt/core.h>

#include <algorithm>
#include <cstddef>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>

namespace foam::texgen {

namespace {

bool is_array(const FlipbookOptions& options) {
    return !options.array_suffix.empty();
}

std::string array_suffix_of(SheetKind sheets) {
    return sheets == SheetKind::Dds ? ".dds" : sheets == SheetKind::Ktx2 ? ".ktx2" : "";
}

std::vector<std::string> maps_of(const BakedSet& set, const FlipbookOptions& options) {
    std::vector<std::string> maps = options.maps;
    for (const ManifestMap& map : set.maps) {
        if (options.maps.empty()) {
            maps.push_back(map.name);
        }
    }
    return maps;
}

SheetLayout layout_of(const BakedSet& set, const FlipbookOptions& options, std::size_t frames) {
    if ((options.strip || is_array(options)) && (options.gutter != 0 || options.columns > 1)) {
        throw std::invalid_argument("a strip or an array must have one column and no gutter");
    }
    SheetLayout layout{.frames = static_cast<int>(frames),
                       .frame_width = set.width,
                       .frame_height = set.height,
                       .columns = options.strip || is_array(options) ? 1 : options.columns,
                       .gutter = options.gutter};
    if (layout.columns == 0) {
        layout.columns =
            near_square_columns(layout.frames, layout.cell_width(), layout.cell_height());
    }
    if (!is_array(options)) {
        check_layout(layout);
    }
    return layout;
}

std::string replaced(std::string text, std::string_view word, std::string_view replacement) {
    for (std::size_t k = text.find(word); k != std::string::npos;
         k = text.find(word, k + replacement.size())) {
        text.replace(k, word.size(), replacement);
    }
    return text;
}

// Returns the pattern of the file names of all sheets: a name without suffix, which contains {map}
// in place of the name of a map.
std::string name_pattern_of(const BakedSet& set, const FlipbookOptions& options) {
    const std::string kind = is_array(options) ? "array" : options.strip ? "strip" : "sheet";
    return replaced(options.names.empty() ? "{preset}_" + kind + "_{map}" : options.names,
                    "{preset}",
                    set.preset);
}

// Returns the file name of a sheet or an array.
std::string file_name_of(const MapSequence& sequence,
                         const std::string& names,
                         const FlipbookOptions& options) {
    const std::string suffix =
        is_array(options) ? options.array_suffix : sequence.files.front().path.extension().string();
    // A file of an unknown format is rejected when it is read.
    const ImageFormat* const format = find_format(suffix);
    if (!is_array(options) && format != nullptr && format->is_lossy) {
        throw std::invalid_argument(
            fmt::format("a sheet of {} files would be compressed twice; with --dds or --ktx2, "
                        "flipbook joins the "
                        "files to an array without any change",
                        suffix));
    }
    const auto word = options.words.find(sequence.map.name);
    return replaced(
               names, "{map}", word != options.words.end() ? word->second : sequence.map.name) +
           suffix;
}

// Returns the name of the JSON file.
std::string json_name_of(const std::string& names) {
    return replaced(replaced(names, "_{map}", ""), "{map}", "sheets") + ".json";
}

// Returns the pattern of the paths of all sheets: a path without suffix, which contains {map} in
// place of the name of a map.
std::string sheet_pattern(const Preset& preset) {
    const std::string& pattern = preset.output.sheet_pattern;
    try {
        return with_placeholders_filled(preset, pattern);
    } catch (const std::invalid_argument& error) {
        throw std::invalid_argument(
            fmt::format("output.sheet_pattern = '{}': {}", pattern, error.what()));
    }
}

// Returns nullptr if the files that a preset writes have a format from which its sheets or arrays
// can be made. Otherwise, returns the names of suitable formats. An array is made of the texels of
// textures, such as DDS files, or of the pixels of PNG files. EXR files contain numbers that arrays
// cannot store. A sheet (unlike an array) cannot be made of lossy files, because they would be
// compressed twice.
const char* needed_formats(const Preset& preset) {
    const FilePattern pattern(preset);
    const bool is_array = !array_suffix_of(preset.output.sheets).empty();
    const bool fits =
        !pattern.is_vector() && (is_array ? pattern.format().samples != FormatSamples::Numbers
                                          : !pattern.format().is_lossy);
    const char* const suitable = is_array ? "PNG, DDS or KTX2 files" : "PNG or EXR files";
    return fits ? nullptr : suitable;
}

}  // namespace

Flipbook write_flipbook(const BakedSet& set,
                        const std::filesystem::path& folder,
                        const FlipbookOptions& options,
                        const std::filesystem::path& to,
                        const ProgressCallback& on_progress) {
    const std::vector<int> frames = options.frames.empty() ? set.frames() : options.frames;
    Flipbook flipbook{{}, layout_of(set, options, frames.size()), {}};
    const std::string names = name_pattern_of(set, options);
    std::vector<MapSequence> sequences;
    for (const std::string& map : maps_of(set, options)) {
        sequences.push_back(map_sequence(set, folder, map, frames));
    }
    ProgressMeter progress(
        Phase::Sheets, static_cast<int>(sequences.size() * frames.size()), on_progress);
    progress.begin();
    const TextureAnimation animation{playing_rate(set, frames), closes(set.loop, frames)};
    // No file gets its name before all files are complete.
    std::vector<StagedFile> staged;
    std::vector<SheetImage> images;
    for (const MapSequence& sequence : sequences) {
        const std::string name = file_name_of(sequence, names, options);
        images.push_back({name, sequence});
        if (is_array(options)) {
            StagedArray array = stage_array(sequence, animation, to / name, progress);
            images.back().texture =
                ArrayTexture{std::string(facts_of(array.format).name), array.mip_levels};
            staged.push_back(std::move(array.file));
        } else {
            staged.push_back(stage_sheet(sequence, flipbook.layout, to / name, progress));
        }
        flipbook.files.push_back(to / name);
    }
    flipbook.files.push_back(to / json_name_of(names));
    Json description = is_array(options) ? array_json(set, frames, images)
                                         : flipbook_json(set, frames, flipbook.layout, images);
    if (std::filesystem::exists(flipbook.files.back())) {
        const Bytes earlier = read_file(flipbook.files.back(), kDescriptionInput);
        flipbook.earlier = keep_earlier_sheets(description, as_text(earlier), to);
    }
    const std::string json = indented(description);
    staged.emplace_back(flipbook.files.back(), std::as_bytes(std::span(json)));
    for (StagedFile& file : staged) {
        file.publish();
    }
    return flipbook;
}

Preset with_sheets_beside_images(Preset preset) {
    std::string& sheets = preset.output.sheet_pattern;
    if (preset.output.sheets != SheetKind::None && sheets.starts_with(kDefaultFolder) &&
        !preset.output.pattern.starts_with(kDefaultFolder)) {
        sheets = (FilePattern(preset).folder() / sheets.substr(kDefaultFolder.size())).string();
    }
    return preset;
}

void check_sheets(const Preset& preset) {
    if (preset.output.sheets == SheetKind::None) {
        return;
    }
    static_cast<void>(sheet_pattern(preset));
    const char* const needed = needed_formats(preset);
    if (needed != nullptr) {
        throw std::invalid_argument(fmt::format(
            "output.sheets = {} needs {}, but output.pattern is '{}'; set output.sheets to "
            "\"none\" for no sheets",
            to_toml(*find_key("output.sheets")->write(preset)),
            needed,
            preset.output.pattern));
    }
}

void check_sheet_folder(const Preset& preset) {
    if (preset.output.sheets != SheetKind::None) {
        check_writable(std::filesystem::path(sheet_pattern(preset)).parent_path());
    }
}

Flipbook write_sheets(const Preset& preset,
                      std::vector<int> frames,
                      const ProgressCallback& on_progress) {
    std::ranges::sort(frames);
    const std::filesystem::path pattern = sheet_pattern(preset);
    FlipbookOptions options{.frames = std::move(frames),
                            .strip = preset.output.sheets == SheetKind::Strip,
                            .array_suffix = array_suffix_of(preset.output.sheets),
                            .names = pattern.filename().string()};
    for (const DrawnImage& image : drawn_images(preset)) {
        options.maps.emplace_back(image.name());
        options.words.emplace(image.name(), file_word(preset, image.name()));
    }
    const std::filesystem::path folder = manifest_folder(preset);
    return write_flipbook(
        read_manifest(folder).sets.back(), folder, options, pattern.parent_path(), on_progress);
}

}  // namespace foam::texgen
