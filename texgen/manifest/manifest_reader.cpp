// SPDX-License-Identifier: Apache-2.0

#include "texgen/bake/frame_range.h"
#include "texgen/image/picture.h"
#include "texgen/json/json_value.h"
#include "texgen/manifest/manifest_json.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <filesystem>
#include <limits>
#include <optional>

namespace foam::texgen {

namespace {

using Words = std::array<std::string_view, 3>;

constexpr Words kKinds = {"color", "number", "id"};
constexpr std::array<std::string_view, 4> kColorSpaces = {"sRGB", "linear sRGB", "ACEScg", "data"};
constexpr Words kAlphas = {"none", "straight", "premultiplied"};
constexpr std::array<std::string_view, 2> kDirections = {"up", "down"};
constexpr int kMaxExtent = 1 << 20;  // largest accepted width or height of images, in pixels

std::vector<int> frames_in(const JsonValue& value) {
    std::vector<int> frames =
        value.parsed(parse_frame_range, "a frame range such as 1-10 or 1-10x2");
    std::ranges::sort(frames);
    return frames;
}

/// Returns the number of a member, or NaN if the member is missing or null. Manifests store
/// infinity and NaN as null.
double number_in(const std::optional<JsonValue>& value) {
    return value ? value->number() : std::numeric_limits<double>::quiet_NaN();
}

std::array<double, 2> range_in(const JsonValue& value) {
    const std::vector<JsonValue> ends = value.items();
    if (ends.size() != 2) {
        value.reject("[low, high]");
    }
    return {ends[0].number(), ends[1].number()};
}

std::optional<MapSamples> samples_in(const JsonValue& value) {
    if (!value.find("kind") || value["kind"].text() == kVectorKind) {
        return std::nullopt;
    }
    MapSamples samples{.kind = value["kind"].word(kKinds),
                       .channels = value["channels"].text(),
                       .type = value["type"].word(sample_type_names()),
                       .color_space = value["color_space"].word(kColorSpaces),
                       .alpha = value["alpha"].word(kAlphas),
                       .range = {}};
    if (const auto range = value.find("range")) {
        samples.range = range_in(*range);
    }
    if (const auto format = value.find("pixel_format")) {
        samples.pixel_format = format->text();
    }
    return samples;
}

std::string vector_format_in(const JsonValue& value) {
    const auto kind = value.find("kind");
    return kind && kind->text() == kVectorKind ? value["type"].text() : "";
}

std::vector<std::string> texts_in(const std::optional<JsonValue>& list) {
    std::vector<std::string> texts;
    for (const JsonValue& item : list ? list->items() : std::vector<JsonValue>()) {
        texts.push_back(item.text());
    }
    return texts;
}

ManifestMap map_in(const JsonValue& value) {
    const auto note = value.find("note");
    return {.name = value["name"].name(),
            .meaning = value["meaning"].text(),
            .unit = value["unit"].text(),
            .note = note ? note->text() : "",
            .frames = frames_in(value["frames"]),
            .samples = samples_in(value),
            .packed = texts_in(value.find("packed")),
            .vector_format = vector_format_in(value)};
}

std::optional<NumberExtent> numbers_in(const JsonValue& file) {
    const auto numbers = file.find("numbers");
    if (!numbers) {
        return std::nullopt;
    }
    const auto [smallest, largest] = range_in(*numbers);
    return NumberExtent{smallest, largest, file["clipped"].number()};
}

/// Returns the path of a file. Throws InputError unless the path stays inside the folder of the
/// manifest, because a manifest may come from another person.
const std::string& path_in(const JsonValue& value) {
    const std::filesystem::path path = value.text();
    if (path.empty() || path.has_root_path() || std::ranges::find(path, "..") != path.end()) {
        value.reject("a path inside the folder of the manifest: relative and without '..'");
    }
    return value.text();
}

ManifestFile file_in(const JsonValue& value) {
    ManifestFile file{.path = path_in(value["path"]),
                      .maps = {},
                      .frame = value["frame"].count(),
                      .bytes = static_cast<std::uint64_t>(
                          value["bytes"].integer(0, std::numeric_limits<std::int64_t>::max())),
                      .pixels = value["pixels"].text(),
                      .numbers = numbers_in(value),
                      .displacement = {}};
    if (const auto displacement = value.find("displacement")) {
        file.displacement = displacement->number();
    }
    file.maps = texts_in(value["maps"]);
    if (file.maps.empty()) {
        value["maps"].reject("at least one map");
    }
    return file;
}

ManifestScene scene_in(const JsonValue& value) {
    return {.path = path_in(value["path"]),
            .format = value["format"].text(),
            .bytes = static_cast<std::uint64_t>(
                value["bytes"].integer(0, std::numeric_limits<std::int64_t>::max())),
            .hash = value["hash"].text()};
}

std::optional<FrameMechanics> mechanics_in(const JsonValue& value) {
    const auto stress = value.find("stress");
    if (!stress) {
        return std::nullopt;
    }
    const std::vector<JsonValue> parts = stress->items();
    if (parts.size() != 3) {
        stress->reject("[xx, xy, yy]");
    }
    return FrameMechanics{.strain = value["strain"].number(),
                          .energy = value["energy"].number(),
                          .stress = {parts[0].number(), parts[1].number(), parts[2].number()}};
}

std::string measurements_in(const JsonValue& value) {
    const auto measurements = value.find("measurements");
    return measurements ? measurements->object_text() : std::string();
}

// Returns a number of T1s or T2s.
std::int64_t event_count_in(const JsonValue& value) {
    return value.integer(0, std::numeric_limits<std::int64_t>::max());
}

FrameStatistics frame_in(const JsonValue& value) {
    return {.frame = value["frame"].count(),
            .tiles = value["tiles"].flag(),
            .time = value["time"].number(),
            .bubbles = value["bubbles"].count(),
            .mean_area = value["mean_area"].number(),
            .t1 = event_count_in(value["t1"]),
            .t2 = event_count_in(value["t2"]),
            .area_error = number_in(value.find("area_error")),
            .angle_error = number_in(value.find("angle_error")),
            .simulating = value["simulating"].number(),
            .drawing = value["drawing"].number(),
            .mechanics = mechanics_in(value),
            .measurements = measurements_in(value)};
}

ManifestLoop loop_in(const JsonValue& value) {
    const auto closing_error = value.find("closing_error");
    return {.kind = value["kind"].text(),
            .description = value["called"].text(),
            .period = value["period"].count(),
            .cross_faded = value["cross_faded"].flag(),
            .closing_error = closing_error ? std::optional(closing_error->number()) : std::nullopt};
}

ManifestConventions conventions_in(const JsonValue& value) {
    return {.rows = value["rows"].text(),
            .normal_y = value["normal_y"].word(kDirections),
            .motion_unit = value["motion_unit"].text(),
            .motion_y = value["motion_y"].word(kDirections),
            .motion_multiplier = value["motion_multiplier"].number()};
}

int extent_in(const JsonValue& size, std::size_t index) {
    const std::vector<JsonValue> extents = size.items();
    if (extents.size() != 2) {
        size.reject("[width, height]");
    }
    return static_cast<int>(extents[index].integer(1, kMaxExtent));
}

template <class Item>
std::vector<Item> list_in(const JsonValue& list, Item (*item_in)(const JsonValue&)) {
    std::vector<Item> items;
    for (const JsonValue& value : list.items()) {
        items.push_back(item_in(value));
    }
    return items;
}

/// Throws InputError if a file has a map that is not in the list of maps of the set. `files` is the
/// JSON list of the files.
void check_maps(const BakedSet& set, const JsonValue& files) {
    const std::vector<JsonValue> items = files.items();
    for (std::size_t k = 0; k < set.files.size(); ++k) {
        for (const std::string& map : set.files[k].maps) {
            if (set.find_map(map) == nullptr) {
                items[k]["maps"].reject("names of maps that are listed in 'maps'");
            }
        }
    }
}

BakedSet set_in(const JsonValue& value) {
    const auto failure = value.find("failure");
    BakedSet set{.version = value["foamtex"].text(),
                 .preset = value["preset"].name(),
                 .description = value["description"].text(),
                 .toml = value["toml"].text(),
                 .parameters = value["parameters"].text(),
                 .seed = static_cast<std::uint64_t>(
                     value["seed"].integer(0, std::numeric_limits<std::int64_t>::max())),
                 .width = extent_in(value["size"], 0),
                 .height = extent_in(value["size"], 1),
                 .frames_per_second = value["frames_per_second"].count(),
                 .loop = loop_in(value["loop"]),
                 .conventions = conventions_in(value["conventions"]),
                 .maps = list_in(value["maps"], map_in),
                 .files = list_in(value["files"], file_in),
                 .frame_statistics = list_in(value["foam"], frame_in),
                 .failure = failure ? failure->text() : ""};
    if (const auto scenes = value.find("scenes")) {
        set.scenes = list_in(*scenes, scene_in);
    }
    if (const auto version = value.find("algorithm_version")) {
        set.algorithm_version =
            static_cast<int>(version->integer(0, std::numeric_limits<int>::max()));
    }
    check_maps(set, value["files"]);
    return set;
}

}  // namespace

Manifest parse_manifest(std::string_view text, const std::string& file) {
    const JsonDocument document(text, file);
    document.check_format("a manifest", kManifestFormat, kManifestVersion);
    return {list_in(document.root()["sets"], set_in)};
}

}  // namespace foam::texgen
