// SPDX-License-Identifier: Apache-2.0

#include "texgen/preset/simulation_keys.h"

#include "texgen/image/pixel_hash.h"
#include "texgen/preset/assignment.h"
#include "texgen/preset/event_io.h"
#include "texgen/preset/preset_keys.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <numeric>
#include <optional>
#include <string_view>

namespace foam::texgen {

namespace {

// The tables of presets that influence only how states are drawn. There are two exceptions: in some
// presets, the camera (needs_camera) and the aspect ratio of the image (needs_aspect) also
// influence the states. The tables of maps also influence only drawing, but are not listed here.
constexpr std::array<std::string_view, 6> kAppearanceTables = {
    "preset", "image", "camera", "output", "vector", "mesh"};

// Returns true if the camera influences the states. This is the case if events of a patch have
// positions, because these positions are fractions of the image.
bool needs_camera(const Preset& preset) {
    return preset.shape.kind == FoamKind::Patch &&
           std::ranges::any_of(preset.events,
                               [](const Event& event) { return event.at.has_value(); });
}

// Returns true if the aspect ratio of the image influences the states. A torus has the aspect ratio
// of the image. In a patch, the positions of events are fractions of the image.
bool needs_aspect(const Preset& preset) {
    return preset.shape.kind == FoamKind::Torus || needs_camera(preset);
}

bool is_table_of_map(std::string_view table) {
    static const Keys<MapOptions> keys_of_maps = map_keys();
    return std::ranges::any_of(keys_of_maps,
                               [&](const KeyInfo& key) { return key.table() == table; });
}

// Returns the keys that `is_included` selects, with their values, one line each. A key that names a
// file is followed by the hash of this file.
template <class IsIncluded>
std::string texts_of(const Preset& preset, const IsIncluded& is_included) {
    std::string text;
    for (const Key<Preset>& key : preset_keys()) {
        if (is_included(key)) {
            text += fmt::format("{} = {}\n", key.path, to_toml(*key.write(preset)));
            const std::optional<NamedFile> file = key.file ? key.file(preset) : std::nullopt;
            text += file ? file->hash + '\n' : "";
        }
    }
    return text;
}

bool affects_simulation(const KeyInfo& key, const Preset& preset) {
    return table_affects_simulation(key.table()) ||
           (key.table() == "camera" && needs_camera(preset));
}

// Returns the aspect ratio in lowest terms, such as "4:3".
std::string aspect_of(const ImageOptions& image) {
    const int common = std::gcd(image.width, image.height);
    return fmt::format("{}:{}", image.width / common, image.height / common);
}

constexpr const char* kAllowed =
    "with a cache, only preset.description, preset.vary and keys of images, output, drawings, "
    "meshes and maps can be changed; for a patch without events at positions, also the camera";

}  // namespace

bool table_affects_simulation(std::string_view table) {
    return std::ranges::find(kAppearanceTables, table) == kAppearanceTables.end() &&
           !is_table_of_map(table);
}

std::string simulation_hash(const Preset& preset) {
    const std::string keys =
        texts_of(preset, [&](const KeyInfo& key) { return affects_simulation(key, preset); });
    return text_hash(FOAMTEX_VERSION "\n" + keys + events_to_toml(preset) +
                     (needs_aspect(preset) ? aspect_of(preset.image) : ""));
}

std::string drawing_hash(const Preset& preset, const Map& map) {
    const std::string keys = texts_of(preset, [&](const KeyInfo& key) {
        return key.table() == "camera" || uses_table(map, key.table());
    });
    return text_hash(simulation_hash(preset) + "\n" + keys);
}

void check_same_simulation(const Preset& simulated, const Preset& changed) {
    for (const Key<Preset>& key : preset_keys()) {
        const std::string was = to_toml(*key.write(simulated));
        const std::string is = to_toml(*key.write(changed));
        if (affects_simulation(key, simulated) && was != is) {
            throw PresetError(fmt::format(
                "key '{}' = {}: must be {}, as in the cache; {}", key.path, is, was, kAllowed));
        }
    }
    if (events_to_toml(simulated) != events_to_toml(changed)) {
        throw PresetError(
            fmt::format("key 'event': must be the same as in the cache; {}", kAllowed));
    }
    const std::string was = aspect_of(simulated.image);
    if (needs_aspect(simulated) && was != aspect_of(changed.image)) {
        throw PresetError(
            fmt::format("key 'image.size' = [{}, {}]: must have the aspect ratio {} of the cache, "
                        "such as [{}, {}]",
                        changed.image.width,
                        changed.image.height,
                        was,
                        simulated.image.width,
                        simulated.image.height));
    }
}

}  // namespace foam::texgen
