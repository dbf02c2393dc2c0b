// SPDX-License-Identifier: Apache-2.0

#include "texgen/material/scene_sources.h"

#include "texgen/maps/all_maps.h"
#include "texgen/material/profile.h"
#include "texgen/preset/drawn_images.h"

#include <string_view>
#include <vector>

namespace foam::texgen {

namespace {

using Images = std::vector<DrawnImage>;

std::optional<std::size_t> find_image(const Images& images, std::string_view map) {
    for (std::size_t k = 0; k < images.size(); ++k) {
        if (images[k].map() != nullptr && images[k].name() == map) {
            return k;
        }
    }
    return std::nullopt;
}

// Returns true if the channels R, G and B of a packing are those of a map of colors.
bool packs_color(const DrawnImage& image, std::string_view map) {
    for (std::size_t c = 0; c < 3; ++c) {
        const PackedChannel* const channel = image.packed_channel(c);
        if (channel == nullptr || channel->map == nullptr || channel->map->name != map ||
            channel->channel != static_cast<int>(c)) {
            return false;
        }
    }
    return true;
}

// Returns the image with the colors of a map: the map itself, or a packing that contains it.
std::optional<std::size_t> find_color(const Images& images, std::string_view map) {
    if (const auto found = find_image(images, map)) {
        return found;
    }
    for (std::size_t k = 0; k < images.size(); ++k) {
        if (images[k].packs_colors() && packs_color(images[k], map)) {
            return k;
        }
    }
    return std::nullopt;
}

// Returns the channel with the numbers of a map that has one channel.
std::optional<SceneSource> find_number(const Images& images, std::string_view map) {
    if (const auto found = find_image(images, map)) {
        return SceneSource{.image = *found};
    }
    for (std::size_t k = 0; k < images.size(); ++k) {
        for (std::size_t c = 0; images[k].packed_channel(c) != nullptr; ++c) {
            const PackedChannel& channel = *images[k].packed_channel(c);
            if (channel.map != nullptr && channel.map->name == map) {
                return SceneSource{k, c, channel.inverted};
            }
        }
    }
    return std::nullopt;
}

void find_normal(const Images& images, const Preset& preset, SceneSources& sources) {
    const bool is_up = preset.maps.normal.y == NormalY::Up;
    sources.normal = find_image(images, is_up ? kNormalMap.name : kNormalGlMap.name);
    if (!sources.normal) {
        sources.normal = find_image(images, is_up ? kNormalGlMap.name : kNormalMap.name);
        sources.is_normal_down = sources.normal && !is_up;
    }
    if (!sources.normal) {
        sources.normal = find_image(images, kNormalDxMap.name);
        sources.is_normal_down = sources.normal.has_value();
    }
}

}  // namespace

bool SceneSources::is_empty() const {
    return !base_color && !lit && !emission && !normal && !roughness && !metallic && !occlusion &&
           !opacity && !height;
}

SceneSources scene_sources(const Preset& preset) {
    const Images images = drawn_images(preset);
    SceneSources sources{.base_color = find_color(images, base_color_map(preset)),
                         .lit = {},
                         .emission = {},
                         .normal = {},
                         .roughness = find_number(images, kRoughnessMap.name),
                         .metallic = find_number(images, kMetallicMap.name),
                         .occlusion = find_number(images, kOcclusionMap.name),
                         .opacity = find_number(images, kOpacityMap.name),
                         .height = find_number(images, kHeightMap.name)};
    if (!sources.base_color) {
        sources.lit = find_color(images, kLitMap.name);
    }
    if (!sources.lit) {
        sources.emission = find_color(images, kEmissionMap.name);
    }
    find_normal(images, preset, sources);
    return sources;
}

}  // namespace foam::texgen
