// SPDX-License-Identifier: Apache-2.0

#include "texgen/maps/all_maps.h"

#include "texgen/keys/nearest.h"
#include "texgen/maps/film_coverage.h"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>
#include <vector>

namespace foam::texgen {

namespace {

// Returns the images of the smooth distance that a map uses.
SmoothImages smooth_images(const Map& map, const MapOptions& options) {
    return map.shows_films ? std::max(map.smooth_images, film_smooth_images(options.albedo))
                           : map.smooth_images;
}

// Returns the option that sets the range of a map, or nullptr if the map has no such option.
// `Options` is MapOptions or const MapOptions.
template <class Options>
auto find_full(const Map& map, Options& options) -> decltype(&options.height.full) {
    const std::array ranges = {std::pair(kHeightMap.full_key, &options.height.full),
                               std::pair(kCurvatureMap.full_key, &options.curvature.full),
                               std::pair(kDistanceMap.full_key, &options.distance.full),
                               std::pair(kAreaMap.full_key, &options.area.full),
                               std::pair(kGrowthMap.full_key, &options.growth.full),
                               std::pair(kAgeMap.full_key, &options.age.full),
                               std::pair(kMotionMap.full_key, &options.motion.multiplier)};
    const auto found =
        std::ranges::find(ranges, map.full_key, [](const auto& range) { return range.first; });
    return found == ranges.end() ? nullptr : found->second;
}

}  // namespace

std::span<const Map> all_maps() {
    return kMaps;
}

std::span<const std::string_view> map_names() {
    static const std::vector<std::string_view> names = [] {
        std::vector<std::string_view> all;
        all.reserve(kMaps.size());
        for (const Map& map : kMaps) {
            all.push_back(map.name);
        }
        return all;
    }();
    return names;
}

const Map& find_map(std::string_view name) {
    const auto* const found =
        std::find_if(kMaps.begin(), kMaps.end(), [&](const Map& map) { return map.name == name; });
    if (found == kMaps.end()) {
        throw std::invalid_argument(fmt::format("unknown map '{}'; must be one of {}{}",
                                                name,
                                                fmt::join(map_names(), ", "),
                                                did_you_mean(name, map_names())));
    }
    return *found;
}

const MapTraits& drawn_traits(const Map& map, const MapOptions& options) {
    return map.name == kPressureMap.name ? pressure_traits(options.pressure) : map;
}

DistanceNeeds distance_needs(std::span<const std::string> names, const MapOptions& options) {
    DistanceNeeds needs{.distance = false};
    for (const std::string& name : names) {
        const Map& map = find_map(name);
        needs.distance = needs.distance || map.needs_distance;
        needs.smooth = std::max(needs.smooth, smooth_images(map, options));
    }
    return needs;
}

AutoReal* range_option_of(const Map& map, MapOptions& options) {
    return find_full(map, options);
}

const AutoReal* range_option_of(const Map& map, const MapOptions& options) {
    return find_full(map, options);
}

// Each row of `users` names a table and the maps that use it, apart from the map that has the name
// of the table. All maps whose MapTraits::shows_relief is true also use the tables relief and maze.
bool uses_table(const Map& map, std::string_view table) {
    struct Users {
        std::string_view table;
        std::vector<std::string_view> maps;
    };
    static const std::vector<Users> users{
        {"albedo",
         {"thin_film", "lit", "emission", "opacity", "film", "distance", "roughness", "metallic"}},
        {"event_map", {"event"}},
        {"lit", {"emission"}},
        {"maze", {"maze_solution", "lit", "emission"}},
        {"occlusion", {"lit"}},
        {"pressure", {"contour"}},
        {"thin_film", {"lit", "emission"}}};
    if (table == map.name || (map.shows_relief && (table == "relief" || table == "maze"))) {
        return true;
    }
    const auto found = std::ranges::find(users, table, &Users::table);
    return found != users.end() && std::ranges::find(found->maps, map.name) != found->maps.end();
}

bool uses_key(const Map& map, std::string_view key, const MapOptions& options) {
    const std::string_view table = key.substr(0, key.find('.'));
    if (!uses_table(map, table)) {
        return false;
    }
    if (key.starts_with("maze.solution_")) {
        return map.name == kMazeSolutionMap.name;
    }
    const bool is_shaded = map.name == kLitMap.name || map.name == kEmissionMap.name;
    const bool shows_walls = map.shows_relief && options.relief.films == ReliefFilms::Walls;
    const auto is_drawn = [&](std::string_view name, LitColors colors) {
        return map.name == name || (is_shaded && options.lit.colors == colors);
    };
    if (table == "albedo" && !is_drawn(kAlbedoMap.name, LitColors::Albedo)) {
        // The glow shows films and the shade beside them, but not the color of the shade.
        const bool glows =
            is_shaded && options.lit.glow > 0.0 && options.lit.colors != LitColors::Maze;
        return key.starts_with("albedo.film_") ||
               (glows && (key == "albedo.shade" || key == "albedo.shade_width"));
    }
    if (table == "thin_film") {
        return is_drawn(kThinFilmMap.name, LitColors::ThinFilm);
    }
    if (table == "maze" && map.name != kMazeSolutionMap.name) {
        return is_drawn(kMazeMap.name, LitColors::Maze) || shows_walls;
    }
    return true;
}

bool shows_maze(std::span<const std::string> names, const MapOptions& options) {
    const bool has_walls = options.relief.films == ReliefFilms::Walls;
    return std::any_of(names.begin(), names.end(), [&](const std::string& name) {
        const bool is_maze = name == kMazeMap.name || name == kMazeSolutionMap.name;
        const bool shows_lit_colors = name == kLitMap.name || name == kEmissionMap.name;
        const bool has_maze_colors = shows_lit_colors && options.lit.colors == LitColors::Maze;
        return is_maze || has_maze_colors || (has_walls && find_map(name).shows_relief);
    });
}

std::string describe_maps_in_markdown() {
    std::string table =
        "| map | what it shows | unit and range | channels | PNG |\n|---|---|---|---|---|\n";
    for (const Map& map : kMaps) {
        table += fmt::format("| `{}` | {} | {} | {} | {} bit |\n",
                             map.name,
                             map.meaning,
                             map.unit,
                             map.channels,
                             map.png_bits);
    }
    return table;
}

}  // namespace foam::texgen
