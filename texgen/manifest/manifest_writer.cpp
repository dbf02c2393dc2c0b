// SPDX-License-Identifier: Apache-2.0

#include "texgen/bake/frame_range.h"
#include "texgen/json/json_writer.h"
#include "texgen/manifest/manifest_json.h"

#include <utility>

namespace foam::texgen {

namespace {

Json to_value(const ManifestMap& map) {
    Json value{{"name", map.name}, {"meaning", map.meaning}, {"unit", map.unit}};
    if (!map.note.empty()) {
        value["note"] = map.note;
    }
    if (!map.packed.empty()) {
        value["packed"] = map.packed;
    }
    value["frames"] = format_frame_range(map.frames);
    if (!map.vector_format.empty()) {
        value["kind"] = kVectorKind;
        value["type"] = map.vector_format;
    }
    if (map.samples) {
        value["kind"] = map.samples->kind;
        value["channels"] = map.samples->channels;
        value["type"] = map.samples->type;
        value["color_space"] = map.samples->color_space;
        value["alpha"] = map.samples->alpha;
    }
    if (map.samples && map.samples->range) {
        value["range"] = *map.samples->range;
    }
    if (map.samples && !map.samples->pixel_format.empty()) {
        value["pixel_format"] = map.samples->pixel_format;
    }
    return value;
}

Json to_value(const ManifestFile& file) {
    Json value{{"path", file.path},
               {"maps", file.maps},
               {"frame", file.frame},
               {"bytes", file.bytes},
               {"pixels", file.pixels}};
    if (file.numbers) {
        value["numbers"] = {file.numbers->smallest, file.numbers->largest};
        value["clipped"] = file.numbers->clipped;
    }
    if (file.displacement) {
        value["displacement"] = *file.displacement;
    }
    return value;
}

Json to_value(const ManifestScene& scene) {
    return {{"path", scene.path},
            {"format", scene.format},
            {"bytes", scene.bytes},
            {"hash", scene.hash}};
}

Json to_value(const FrameStatistics& frame) {
    Json value{{"frame", frame.frame},
               {"tiles", frame.tiles},
               {"time", frame.time},
               {"bubbles", frame.bubbles},
               {"mean_area", frame.mean_area},
               {"t1", frame.t1},
               {"t2", frame.t2},
               {"area_error", number_or_null(frame.area_error)},
               {"angle_error", number_or_null(frame.angle_error)},
               {"simulating", frame.simulating},
               {"drawing", frame.drawing}};
    if (frame.mechanics) {
        value["strain"] = frame.mechanics->strain;
        value["energy"] = frame.mechanics->energy;
        value["stress"] = frame.mechanics->stress;
    }
    if (!frame.measurements.empty()) {
        value["measurements"] = Json::parse(frame.measurements);
    }
    return value;
}

Json to_value(const ManifestLoop& loop) {
    // "called" is a description of the kind for users. The name is part of the format.
    return {{"kind", loop.kind},
            {"called", loop.description},
            {"period", loop.period},
            {"cross_faded", loop.cross_faded},
            {"closing_error", number_or_null(loop.closing_error)}};
}

Json to_value(const ManifestConventions& conventions) {
    return {{"rows", conventions.rows},
            {"normal_y", conventions.normal_y},
            {"motion_unit", conventions.motion_unit},
            {"motion_y", conventions.motion_y},
            {"motion_multiplier", conventions.motion_multiplier}};
}

Json time_used(const std::vector<FrameStatistics>& frames) {
    double simulating = 0.0;
    double drawing = 0.0;
    for (const FrameStatistics& frame : frames) {
        simulating += frame.simulating;
        drawing += frame.drawing;
    }
    return {{"simulating", simulating}, {"drawing", drawing}};
}

/// Returns a JSON list with one line per item.
template <class Item>
std::string lines_of(const std::vector<Item>& items) {
    std::string lines;
    for (const Item& item : items) {
        lines += (lines.empty() ? "\n        " : ",\n        ") + json_text(to_value(item));
    }
    return "[" + lines + "]";
}

std::string to_text(const BakedSet& set) {
    std::vector<std::pair<const char*, std::string>> members{
        {"foamtex", json_text(Json(set.version))},
        {"algorithm_version", json_text(Json(set.algorithm_version))},
        {"preset", json_text(Json(set.preset))},
        {"description", json_text(Json(set.description))},
        {"seed", json_text(Json(set.seed))},
        {"parameters", json_text(Json(set.parameters))},
        {"complete", json_text(Json(set.complete()))},
        {"failure", set.failure.empty() ? "null" : json_text(Json(set.failure))},
        {"size", json_text(Json({set.width, set.height}))},
        {"frames_per_second", json_text(Json(set.frames_per_second))},
        {"loop", json_text(to_value(set.loop))},
        {"conventions", json_text(to_value(set.conventions))},
        {"seconds", json_text(time_used(set.frame_statistics))},
        {"maps", lines_of(set.maps)},
        {"files", lines_of(set.files)},
        {"foam", lines_of(set.frame_statistics)},
        {"toml", json_text(Json(set.toml))}};
    if (!set.scenes.empty()) {
        members.insert(members.end() - 1, {"scenes", lines_of(set.scenes)});
    }
    std::string text;
    for (const auto& [name, value] : members) {
        text += (text.empty() ? "      \"" : ",\n      \"") + std::string(name) + "\": " + value;
    }
    return "    {\n" + text + "\n    }";
}

}  // namespace

std::string to_json(const Manifest& manifest) {
    std::string sets;
    for (const BakedSet& set : manifest.sets) {
        sets += (sets.empty() ? "\n" : ",\n") + to_text(set);
    }
    return "{\n  \"format\": \"" + std::string(kManifestFormat) +
           "\",\n  \"version\": " + std::to_string(kManifestVersion) + ",\n  \"sets\": [" + sets +
           "\n  ]\n}\n";
}

}  // namespace foam::texgen
