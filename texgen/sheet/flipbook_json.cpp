// SPDX-License-Identifier: Apache-2.0

#include "texgen/sheet/flipbook_json.h"

#include "texgen/bake/frame_range.h"
#include "texgen/json/json_writer.h"
#include "texgen/maps/height.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace foam::texgen {

namespace {

// Displacements whose relative difference is at most this number count as equal.
constexpr double kSameDisplacement = 1e-9;

Json loop_value(const BakedSet& set, std::span<const int> frames) {
    return {{"kind", set.loop.kind},
            // A description of the kind for users; the name "called" is part of the format.
            {"called", set.loop.description},
            {"closes", closes(set.loop, frames)},
            {"cross_faded", set.loop.cross_faded}};
}

Json conventions_value(const ManifestConventions& conventions) {
    return {{"normal_y", conventions.normal_y},
            {"motion_unit", conventions.motion_unit},
            {"motion_y", conventions.motion_y},
            {"motion_multiplier", conventions.motion_multiplier}};
}

// Returns the layout in texture coordinates. The origin is the top left corner of the sheet.
// Frames, columns and rows are counted from 0. Frame k is in column `k mod columns` and in row
// `k / columns`, rounded down. The top left corner of the frame is at (column, row) * cell + inset,
// where * multiplies component by component. The size of the frame is `frame`.
Json uv_value(const SheetLayout& layout) {
    const auto width = static_cast<double>(layout.width());
    const auto height = static_cast<double>(layout.height());
    return {{"origin", "top left"},
            {"cell", {layout.cell_width() / width, layout.cell_height() / height}},
            {"inset", {layout.gutter / width, layout.gutter / height}},
            {"frame", {layout.frame_width / width, layout.frame_height / height}}};
}

Json layout_value(const SheetLayout& layout, bool tiles) {
    return {{"size", {layout.width(), layout.height()}},
            {"frame_size", {layout.frame_width, layout.frame_height}},
            {"columns", layout.columns},
            {"rows", layout.rows()},
            {"gutter", layout.gutter},
            {"gutter_shows", tiles ? "the frame's other side" : "the frame's edge"},
            {"order", "left to right, top to bottom"},
            {"uv", uv_value(layout)}};
}

// Returns the displacement of a map: a height, as a fraction of the width of the image. The
// displacement tells which heights the samples of the map represent (WrittenFile::displacement).
// Returns null if frames have different displacements, or if the displacement of a frame is not
// recorded.
Json displacement_value(const BakedSet& set, std::span<const int> frames, const std::string& map) {
    std::optional<double> common;
    for (const int frame : frames) {
        const ManifestFile* const file = set.find_file(map, frame);
        if (file == nullptr || !file->displacement ||
            (common && std::abs(*file->displacement - *common) > kSameDisplacement * *common)) {
            return nullptr;
        }
        common = file->displacement;
    }
    return number_or_null(common);
}

// Returns true if a channel of a packed image contains heights.
bool packs_height(const ManifestMap& map) {
    return std::ranges::any_of(map.packed, [](const std::string& channel) {
        return channel == kHeightMap.name || channel == "1-" + std::string(kHeightMap.name);
    });
}

Json image_value(const SheetImage& image, const BakedSet& set, std::span<const int> frames) {
    const ManifestMap& map = image.sequence.map;
    Json value{
        {"file", image.file}, {"map", map.name}, {"meaning", map.meaning}, {"unit", map.unit}};
    if (!map.note.empty()) {
        value["note"] = map.note;
    }
    if (!map.packed.empty()) {
        value["packed"] = map.packed;
    }
    value["kind"] = map.samples->kind;
    value["channels"] = map.samples->channels;
    value["type"] = map.samples->type;
    value["color_space"] = map.samples->color_space;
    value["alpha"] = map.samples->alpha;
    if (map.samples->range) {
        value["range"] = *map.samples->range;
    }
    if (image.texture) {
        value["pixel_format"] = image.texture->pixel_format;
        value["mip_levels"] = image.texture->mip_levels;
    }
    if (map.name == kHeightMap.name || packs_height(map)) {
        value["displacement"] = displacement_value(set, frames, map.name);
    }
    return value;
}

bool all_tile(std::span<const SheetImage> images) {
    return std::ranges::all_of(images, [](const auto& image) { return image.sequence.tiles(); });
}

Json array_layout_value(const BakedSet& set, std::span<const int> frames) {
    return {{"frame_size", {set.width, set.height}},
            {"layers", frames.size()},
            {"order", "layer 0 is the first frame"}};
}

Json description_of(const BakedSet& set,
                    std::span<const int> frames,
                    const Json& layout,
                    std::span<const SheetImage> images) {
    const FrameRate rate = playing_rate(set, frames);
    Json json{{"format", "foamtex-flipbook"},
              {"version", 1},
              {"foamtex", set.version},
              {"preset", set.preset},
              {"parameters", set.parameters},
              {"seed", set.seed},
              {"frames", frames.size()},
              {"frame_numbers", format_frame_range(frames)},
              {"frames_per_second", static_cast<double>(rate.frames) / rate.seconds},
              {"tiles", all_tile(images)},
              {"loop", loop_value(set, frames)},
              {"conventions", conventions_value(set.conventions)},
              {"layout", layout},
              {"images", Json::array()}};
    for (const SheetImage& image : images) {
        json["images"].push_back(image_value(image, set, frames));
    }
    return json;
}

}  // namespace

Json flipbook_json(const BakedSet& set,
                   std::span<const int> frames,
                   const SheetLayout& layout,
                   std::span<const SheetImage> images) {
    return description_of(set, frames, layout_value(layout, all_tile(images)), images);
}

Json array_json(const BakedSet& set,
                std::span<const int> frames,
                std::span<const SheetImage> images) {
    return description_of(set, frames, array_layout_value(set, frames), images);
}

}  // namespace foam::texgen
