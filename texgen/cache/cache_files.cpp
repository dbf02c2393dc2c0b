// SPDX-License-Identifier: Apache-2.0

#include "texgen/cache/cache_files.h"

#include "core/files/file_io.h"
#include "texgen/bake/frame_range.h"
#include "texgen/json/json_value.h"
#include "texgen/json/json_writer.h"
#include "texgen/preset/assignment.h"
#include "texgen/preset/preset_io.h"

#include <fmt/core.h>

#include <span>
#include <system_error>

namespace foam::texgen {

namespace {

constexpr const char* kFormat = "foamtex-cache";
constexpr int kVersion = 1;

Preset preset_in(const JsonValue& root, const std::string& file) {
    try {
        return parse_preset(root["toml"].text(), root["preset"].name(), "toml");
    } catch (const PresetError& error) {
        fail_to_read(file, error.what());
    }
}

CacheInfo info_in(const JsonDocument& document, const std::string& file) {
    document.check_format("a cache", kFormat, kVersion);
    const JsonValue root = document.root();
    const auto closing_error = root.find("closing_error");
    return {
        .preset = preset_in(root, file),
        .version = root["foamtex"].text(),
        .simulation = root["simulation"].text(),
        .frames = root["frames"].parsed(parse_frame_range, "a frame range such as 1-10 or 1-10x2"),
        .closing_error = closing_error ? std::optional(closing_error->number()) : std::nullopt};
}

}  // namespace

bool is_cache(const std::filesystem::path& path) {
    std::error_code ignored;
    return std::filesystem::exists(path / kCacheName, ignored);
}

std::filesystem::path state_path(const std::filesystem::path& folder, int number) {
    return folder / fmt::format("state.{:06}.foam", number);
}

std::filesystem::path pressures_path(const std::filesystem::path& folder) {
    return folder / "pressures.foam";
}

void write_info(const CacheInfo& info, const std::filesystem::path& folder) {
    const Json value{{"format", kFormat},
                     {"version", kVersion},
                     {"foamtex", info.version},
                     {"preset", info.preset.name},
                     {"frames", format_frame_range(info.frames)},
                     {"closing_error", number_or_null(info.closing_error)},
                     {"simulation", info.simulation},
                     {"toml", to_toml(info.preset)}};
    const std::string text = indented(value);
    write_file(folder / kCacheName, std::as_bytes(std::span(text)), Durability::BeforeNaming);
}

CacheInfo parse_info(std::string_view text, const std::string& file) {
    return info_in(JsonDocument(text, file), file);
}

CacheInfo read_info(const std::filesystem::path& folder) {
    const std::filesystem::path file = folder / kCacheName;
    return info_in(JsonDocument::read(file), file.string());
}

}  // namespace foam::texgen
