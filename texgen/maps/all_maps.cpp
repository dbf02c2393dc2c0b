#include "texgen/maps/film.h"
#include "texgen/maps/id_color.h"
#include "texgen/maps/map.h"
#include "texgen/maps/opacity.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <stdexcept>
#include <vector>

namespace foam::texgen {

namespace {

constexpr std::array kMaps = {
    Map{.name = "albedo",
        .meaning = "colours of bubbles by their pressure, and of films",
        .unit = "light",
        .channels = "R G B",
        .draw = [](FrameLayers& layers, const MapOptions& options) -> MapImage {
            return draw_albedo(layers, options.albedo);
        }},
    Map{.name = "pressure",
        .meaning = "pressure of bubbles, scaled alike in all frames",
        .unit = "0 to 1",
        .channels = "Y",
        .draw = [](FrameLayers& layers, const MapOptions& options) -> MapImage {
            return draw_pressure(layers, options.pressure);
        }},
    Map{.name = "film",
        .meaning = "mask of the films, as wide as those of albedo",
        .unit = "part of the pixel, 0 to 1",
        .channels = "Y",
        .draw = [](FrameLayers& layers, const MapOptions& options) -> MapImage {
            return draw_film(layers, options.albedo);
        }},
    Map{.name = "opacity",
        .meaning = "what foam covers, albedo's alpha; all of a torus",
        .unit = "part of the pixel, 0 to 1",
        .channels = "Y",
        .draw = [](FrameLayers& layers, const MapOptions& options) -> MapImage {
            return draw_opacity(layers, options.albedo);
        }},
    Map{.name = "id_color",
        .meaning = "a colour for every bubble, its own for life",
        .unit = "light",
        .channels = "R G B",
        .draw = [](FrameLayers& layers, const MapOptions&) -> MapImage {
            return draw_id_color(layers);
        }},
    Map{.name = "area",
        .meaning = "area of bubbles",
        .unit = "mean areas; PNG: 0 to area.full",
        .channels = "Y",
        .draw = [](FrameLayers& layers, const MapOptions& options) -> MapImage {
            return draw_area(layers, options.area);
        }},
};

std::vector<std::string_view> names_of_maps() {
    std::vector<std::string_view> names;
    for (const Map& map : kMaps) {
        names.push_back(map.name);
    }
    return names;
}

}  // namespace

std::span<const Map> all_maps() {
    return kMaps;
}

std::span<const std::string_view> map_names() {
    static const std::vector<std::string_view> names = names_of_maps();
    return names;
}

const Map& find_map(std::string_view name) {
    const auto* const found =
        std::find_if(kMaps.begin(), kMaps.end(), [&](const Map& map) { return map.name == name; });
    if (found != kMaps.end()) {
        return *found;
    }
    std::string known;
    for (const std::string_view one : map_names()) {
        known += fmt::format("{}{}", known.empty() ? "" : ", ", one);
    }
    throw std::invalid_argument(fmt::format("there is no map '{}'; there are {}", name, known));
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
