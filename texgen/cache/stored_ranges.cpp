// SPDX-License-Identifier: Apache-2.0

#include "texgen/cache/stored_ranges.h"

#include "core/files/file_io.h"
#include "texgen/bake/fitted_ranges.h"
#include "texgen/bake/frame_range.h"
#include "texgen/bake/reduced_image.h"
#include "texgen/image/pixel_hash.h"
#include "texgen/json/json_value.h"
#include "texgen/json/json_writer.h"
#include "texgen/maps/all_maps.h"
#include "texgen/preset/simulation_keys.h"

#include <fmt/core.h>

#include <cmath>
#include <span>

namespace foam::texgen {

namespace {

constexpr const char* kFormat = "foamtex-range";
constexpr int kVersion = 1;

double range_in(const std::filesystem::path& file) {
    const JsonDocument document = JsonDocument::read(file);
    document.check_format("a range", kFormat, kVersion);
    const JsonValue full = document.root()["full"];
    if (!std::isfinite(full.number()) || full.number() <= 0.0) {
        full.reject("a positive number");
    }
    return full.number();
}

}  // namespace

StoredRanges::StoredRanges(const Preset& preset,
                           const std::vector<int>& frames,
                           const std::filesystem::path& folder) {
    const ReducedImage measured = reduced_image(preset, kMeasuredSide);
    const std::string hash = text_hash(fmt::format("{}\n{}x{}\n{}",
                                                   drawing_hash(preset),
                                                   measured.width,
                                                   measured.height,
                                                   format_frame_range(frames)));
    for (const Map* const map : maps_with_automatic_ranges(preset)) {
        const std::string name(map->name);
        files_[name] = folder / fmt::format("range.{}.{}.json", name, hash);
    }
}

bool StoredRanges::load(Preset& preset) const {
    Preset fitted = preset;
    try {
        for (const auto& [name, file] : files_) {
            range_option_of(find_map(name), fitted.maps)->value = range_in(file);
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
            const Json range{{"format", kFormat},
                             {"version", kVersion},
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
