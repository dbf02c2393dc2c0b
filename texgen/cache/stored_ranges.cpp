// SPDX-License-Identifier: Apache-2.0

#include "texgen/cache/stored_ranges.h"

#include "core/files/file_io.h"
#include "texgen/bake/fitted_ranges.h"
#include "texgen/bake/frame_range.h"
#include "texgen/image/pixel_hash.h"
#include "texgen/json/json_value.h"
#include "texgen/json/json_writer.h"
#include "texgen/maps/all_maps.h"
#include "texgen/preset/simulation_keys.h"

#include <fmt/core.h>

#include <algorithm>
#include <span>

namespace foam::texgen {

namespace {

constexpr const char* kRangeFormat = "foamtex-range";
constexpr int kRangeVersion = 1;

// Returns the range that a file stores for a map. Throws InputError if the file is missing or
// malformed, or if the key of the range does not allow this range, because the file may come from
// an untrusted source.
double range_in(const std::filesystem::path& file, const Map& map) {
    const JsonDocument document = JsonDocument::read(file);
    document.check_format("a range", kRangeFormat, kRangeVersion);
    const JsonValue full = document.root()["full"];
    const Keys<MapOptions> keys = map_keys();
    const auto key = std::ranges::find(keys, map.full_key, &Key<MapOptions>::path);
    MapOptions options;
    if (document.root()["map"].text() != map.name || !key->read({full.number()}, options)) {
        full.reject(key->allowed);
    }
    return full.number();
}

// Returns a hash of everything that influences the range of a map if this range is fitted to the
// given frames of a preset.
std::string hash_of(const Preset& preset, const Map& map, const std::vector<int>& frames) {
    return text_hash(fmt::format("{}\n{}x{}\n{}",
                                 drawing_hash(preset, map),
                                 preset.image.width,
                                 preset.image.height,
                                 format_frame_range(frames)));
}

}  // namespace

StoredRanges::StoredRanges(const Preset& preset,
                           const std::vector<int>& frames,
                           const std::filesystem::path& folder) {
    for (const Map* const map : maps_with_automatic_ranges(preset)) {
        const std::string name(map->name);
        files_[name] =
            folder / fmt::format("range.{}.{}.json", name, hash_of(preset, *map, frames));
    }
}

bool StoredRanges::load(Preset& preset) const {
    Preset fitted = preset;
    try {
        for (const auto& [name, file] : files_) {
            range_option_of(find_map(name), fitted.maps)->value = range_in(file, find_map(name));
        }
    } catch (const InputError&) {
        return false;  // a file is missing or damaged
    }
    preset = fitted;
    return true;
}

void StoredRanges::save(const Preset& preset) const {
    try {
        for (const auto& [name, file] : files_) {
            const Json range{{"format", kRangeFormat},
                             {"version", kRangeVersion},
                             {"map", name},
                             {"full", range_option_of(find_map(name), preset.maps)->value}};
            const std::string text = indented(range);
            write_file(file, std::as_bytes(std::span(text)));
        }
    } catch (const OutputError&) {
        return;
    }
}

}  // namespace foam::texgen
