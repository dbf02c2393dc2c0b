// SPDX-License-Identifier: Apache-2.0

#include "texgen/preset/preset_remarks.h"

#include "texgen/maps/all_maps.h"
#include "texgen/preset/conditions.h"
#include "texgen/preset/drawn_images.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <utility>

namespace foam::texgen {

namespace {

/// Returns the end of a line about a key that no drawn map uses. If a drawn map would use the key
/// with another value of lit.colors, the result names the present value, for example: with
/// lit.colors = "albedo". Otherwise, the result is empty.
std::string colors_remark(std::span<const Map* const> drawn,
                          const Key<MapOptions>& key,
                          const Preset& preset) {
    const auto is_used_with = [&](LitColors colors) {
        MapOptions options = preset.maps;
        options.lit.colors = colors;
        return std::ranges::any_of(
            drawn, [&](const Map* map) { return uses_key(*map, key.path, options); });
    };
    constexpr std::array kAll = {LitColors::Albedo, LitColors::ThinFilm, LitColors::Maze};
    return std::ranges::any_of(kAll, is_used_with)
               ? fmt::format(" with lit.colors = {}",
                             to_toml(*find_key("lit.colors")->write(preset)))
               : "";
}

}  // namespace

DensityDomain density_domain(const Preset& preset) {
    if (preset.shape.kind == FoamKind::Torus) {
        return {true, static_cast<double>(preset.image.width) / preset.image.height};
    }
    return {false, bounding_aspect(outline_of(preset.shape))};
}

std::vector<std::string> remarks_on(const Preset& preset, std::span<const Assignment> assignments) {
    std::vector<std::string> remarks = unused_keys(preset, assignments);
    if (preset.density.source.picture.is_set()) {
        std::ranges::copy(density_remarks(preset.density, density_domain(preset)),
                          std::back_inserter(remarks));
    }
    return remarks;
}

std::vector<std::string> keys_without_maps(const Preset& preset,
                                           std::span<const Assignment> assignments) {
    const Keys<MapOptions> keys_of_maps = map_keys();
    const std::vector<const Map*> drawn = source_maps(preset);
    std::vector<std::string> lines;
    for (const Assignment& assignment : assignments) {
        const auto key = std::ranges::find(keys_of_maps, assignment.key, &Key<MapOptions>::path);
        const auto uses_this_key = [&](const Map* map) {
            return uses_key(*map, key->path, preset.maps);
        };
        if (key == keys_of_maps.end() || std::ranges::any_of(drawn, uses_this_key)) {
            continue;
        }
        std::string line = fmt::format("{} has no effect on the drawn map{} {}{}",
                                       key->path,
                                       drawn.size() == 1 ? "" : "s",
                                       fmt::join(source_map_names(preset), ", "),
                                       colors_remark(drawn, *key, preset));
        if (std::ranges::find(lines, line) == lines.end()) {
            lines.push_back(std::move(line));
        }
    }
    return lines;
}

}  // namespace foam::texgen
