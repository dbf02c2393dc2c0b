#include "texgen/cache/cache_files.h"

#include "texgen/bake/frame_range.h"
#include "texgen/image/file_io.h"
#include "texgen/manifest/json_value.h"
#include "texgen/preset/assignment.h"
#include "texgen/preset/preset_io.h"

#include <fmt/core.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <span>
#include <stdexcept>

namespace foam::texgen {

namespace {

using Json = nlohmann::ordered_json;

constexpr const char* kFormat = "foamtex-cache";
constexpr int kVersion = 1;

nlohmann::json tree_in(const std::filesystem::path& file) {
    const Bytes bytes = read_file(file);
    const auto* const begin = reinterpret_cast<const char*>(bytes.data());
    try {
        return nlohmann::json::parse(begin, begin + bytes.size());
    } catch (const nlohmann::json::exception& error) {
        throw InputError(fmt::format("cannot read '{}': {}", file.string(), error.what()));
    }
}

std::vector<int> frames_in(const JsonValue& value) {
    try {
        return parse_frame_range(value.text());
    } catch (const std::invalid_argument&) {
        value.refuse("frames as 1-10 or 1-10x2");
    }
}

Preset preset_in(const JsonValue& root, const std::filesystem::path& file) {
    try {
        return parse_preset(root["toml"].text(), root["preset"].text(), "toml");
    } catch (const PresetError& error) {
        throw InputError(fmt::format("cannot read '{}': {}", file.string(), error.what()));
    }
}

}  // namespace

std::filesystem::path state_path(const std::filesystem::path& folder, int number) {
    return folder / fmt::format("state.{:06}.foam", number);
}

std::filesystem::path pressures_path(const std::filesystem::path& folder) {
    return folder / "pressures.foam";
}

void write_info(const CacheInfo& info, const std::filesystem::path& folder) {
    const bool closed = info.closing_error && std::isfinite(*info.closing_error);
    const Json value{{"format", kFormat},
                     {"version", kVersion},
                     {"foamtex", FOAMTEX_VERSION},
                     {"preset", info.preset.name},
                     {"frames", format_frame_range(info.frames)},
                     {"closing_error", closed ? Json(*info.closing_error) : Json(nullptr)},
                     {"simulation", info.simulation},
                     {"toml", to_toml(info.preset)}};
    const std::string text = value.dump(2) + "\n";
    write_file(folder / kCacheName, std::as_bytes(std::span(text)));
}

CacheInfo read_info(const std::filesystem::path& folder) {
    const std::filesystem::path file = folder / kCacheName;
    const nlohmann::json tree = tree_in(file);
    const JsonValue root(tree, file.string());
    if (!tree.is_object() || !tree.contains("format") || tree["format"] != kFormat) {
        root.refuse(fmt::format("a cache, with \"format\": \"{}\"", kFormat));
    }
    root["version"].integer(kVersion, kVersion);
    const auto closing_error = root.find("closing_error");
    return {.preset = preset_in(root, file),
            .simulation = root["simulation"].text(),
            .frames = frames_in(root["frames"]),
            .closing_error = closing_error ? std::optional(closing_error->number()) : std::nullopt};
}

}  // namespace foam::texgen
