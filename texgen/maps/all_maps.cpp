#include "texgen/maps/film.h"
#include "texgen/maps/film_look.h"
#include "texgen/maps/id.h"
#include "texgen/maps/id_color.h"
#include "texgen/maps/lit.h"
#include "texgen/maps/map.h"
#include "texgen/maps/opacity.h"
#include "texgen/maps/sides.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <stdexcept>
#include <vector>

namespace foam::texgen {

namespace {

DistanceNeeds smooth_distance(const MapOptions& /*options*/) {
    return {.smooth = true};
}

DistanceNeeds distance_of_films(const MapOptions& options) {
    return distance_of_look(options.albedo);
}

constexpr std::array kMaps = {
    Map{.name = "albedo",
        .meaning = "colours of bubbles by their pressure, and of films",
        .unit = "light",
        .channels = "R G B",
        .distance = distance_of_films,
        .draw = [](FrameLayers& layers, const MapOptions& options) -> MapImage {
            return draw_albedo(layers, options.albedo);
        }},
    Map{.name = "thin_film",
        .meaning = "interference colours of a soap film across every bubble",
        .unit = "light",
        .channels = "R G B",
        .png_filter = PngFilter::Up,
        .distance = smooth_distance,
        .draw = [](FrameLayers& layers, const MapOptions& options) -> MapImage {
            return draw_thin_film(layers, options.thin_film, options.albedo);
        }},
    Map{.name = "lit",
        .meaning = "albedo or thin_film on the relief, under a light",
        .unit = "light",
        .channels = "R G B",
        .png_filter = PngFilter::Up,
        .draw = [](FrameLayers& layers, const MapOptions& options) -> MapImage {
            return draw_lit(layers, options);
        }},
    Map{.name = "opacity",
        .meaning = "what foam covers, albedo's alpha; all of a torus",
        .unit = "part of the pixel, 0 to 1",
        .channels = "Y",
        .distance = distance_of_films,
        .draw = [](FrameLayers& layers, const MapOptions& options) -> MapImage {
            return draw_opacity(layers, options.albedo);
        }},
    Map{.name = "film",
        .meaning = "mask of the films, as wide as those of albedo",
        .unit = "part of the pixel, 0 to 1",
        .channels = "Y",
        .distance = distance_of_films,
        .draw = [](FrameLayers& layers, const MapOptions& options) -> MapImage {
            return draw_film(layers, options.albedo);
        }},
    Map{.name = "distance",
        .meaning = "distance to the nearest film, plain or signed",
        .unit = "foam units or pixels; PNG: 0 to distance.full, signed from its negative",
        .channels = "Y",
        .png_bits = 16,
        .png_filter = PngFilter::Up,
        .draw = [](FrameLayers& layers, const MapOptions& options) -> MapImage {
            return draw_distance(layers, options.distance, options.albedo);
        }},
    Map{.name = "height",
        .meaning = "relief: domes, ridges on films, or wet films with Plateau borders",
        .unit = "bubble diameters; PNG: 0 to height.full",
        .channels = "Y",
        .png_bits = 16,
        .png_filter = PngFilter::Up,
        .distance = smooth_distance,
        .draw = [](FrameLayers& layers, const MapOptions& options) -> MapImage {
            return draw_height(layers, options.relief, options.height);
        }},
    Map{.name = "normal",
        .meaning = "the relief's normals, y up (OpenGL) or down (DirectX)",
        .unit = "-1 to 1; PNG: 0.5 is 0",
        .channels = "X Y Z",
        .png_filter = PngFilter::Up,
        .distance = smooth_distance,
        .around = 1.0,
        .mixing = Mixing::Slopes,
        .note = [](const MapOptions& options) { return note_on_normals(options.normal); },
        .draw = [](FrameLayers& layers, const MapOptions& options) -> MapImage {
            return draw_normal(layers, options.relief, options.normal);
        }},
    Map{.name = "occlusion",
        .meaning = "the part of an even sky that the relief sees",
        .unit = "0 to 1",
        .channels = "Y",
        .png_filter = PngFilter::Up,
        .distance = smooth_distance,
        .around = 1.0,
        .draw = [](FrameLayers& layers, const MapOptions& options) -> MapImage {
            return draw_occlusion(layers, options.relief, options.occlusion);
        }},
    Map{.name = "curvature",
        .meaning = "how the relief bends: above 0 on crests, below in furrows",
        .unit = "per bubble diameter; PNG: 0.5 is 0, ends at curvature.full",
        .channels = "Y",
        .png_bits = 16,
        .png_filter = PngFilter::Up,
        .distance = smooth_distance,
        .draw = [](FrameLayers& layers, const MapOptions& options) -> MapImage {
            return draw_curvature(layers, options.relief, options.curvature);
        }},
    Map{.name = "roughness",
        .meaning = "of a surface: bubbles are smoother than films, and differ a little",
        .unit = "0 to 1",
        .channels = "Y",
        .distance = distance_of_films,
        .draw = [](FrameLayers& layers, const MapOptions& options) -> MapImage {
            return draw_roughness(layers, options.roughness, options.albedo);
        }},
    Map{.name = "pressure",
        .meaning = "pressure of bubbles, scaled alike in all frames",
        .unit = "0 to 1",
        .channels = "Y",
        .png_bits = 16,
        .draw = [](FrameLayers& layers, const MapOptions& options) -> MapImage {
            return draw_pressure(layers, options.pressure);
        }},
    Map{.name = "area",
        .meaning = "area of bubbles",
        .unit = "mean areas; PNG: 0 to area.full",
        .channels = "Y",
        .png_bits = 16,
        .draw = [](FrameLayers& layers, const MapOptions& options) -> MapImage {
            return draw_area(layers, options.area);
        }},
    Map{.name = "sides",
        .meaning = "number of films around a bubble, exact",
        .unit = "films; PNG: as it is",
        .channels = "Y",
        .draw = [](FrameLayers& layers, const MapOptions&) -> MapImage {
            return draw_sides(layers);
        }},
    Map{.name = "id",
        .meaning = "number of a bubble for life plus 1, exact; 0 around a patch",
        .unit = "PNG: lowest 16 bits",
        .channels = "Y",
        .png_bits = 16,
        .draw = [](FrameLayers& layers, const MapOptions&) -> MapImage { return draw_id(layers); }},
    Map{.name = "id_color",
        .meaning = "a colour for every bubble, its own for life",
        .unit = "light",
        .channels = "R G B",
        .draw = [](FrameLayers& layers, const MapOptions&) -> MapImage {
            return draw_id_color(layers);
        }},
    Map{.name = "age",
        .meaning = "time since a bubble was born, or its neighbours changed",
        .unit = "foam time; PNG: 0 to age.full",
        .channels = "Y",
        .png_bits = 16,
        .draw = [](FrameLayers& layers, const MapOptions& options) -> MapImage {
            return draw_age(layers, options.age);
        }},
    Map{.name = "growth",
        .meaning = "how fast bubbles grow, to the next frame",
        .unit = "area per foam time; PNG: 0.5 is 0, ends at growth.full",
        .channels = "Y",
        .png_bits = 16,
        .needs_next = true,
        .draw = [](FrameLayers& layers, const MapOptions& options) -> MapImage {
            return draw_growth(layers, options.growth);
        }},
    Map{.name = "motion",
        .meaning = "where every place goes, to the next frame",
        .unit = "parts of the width, or pixels; PNG: 0.5 is still, ends at motion.multiplier",
        .channels = "X Y",
        .png_bits = 16,
        .png_filter = PngFilter::Up,
        .needs_next = true,
        .note = [](const MapOptions& options) { return note_on_motion(options.motion); },
        .draw = [](FrameLayers& layers, const MapOptions& options) -> MapImage {
            return draw_motion(layers, options.motion);
        }},
    Map{.name = "event",
        .meaning = "spots where T1 (red), T2 (green) and births (blue) just happened, fading",
        .unit = "0 to 1",
        .channels = "R G B",
        .png_filter = PngFilter::Up,
        .draw = [](FrameLayers& layers, const MapOptions& options) -> MapImage {
            return draw_event(layers, options.event_map);
        }},
};

std::vector<std::string_view> names_of_maps() {
    std::vector<std::string_view> names;
    names.reserve(kMaps.size());
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

DistanceNeeds distance_needs(std::span<const std::string> names, const MapOptions& options) {
    DistanceNeeds needs;
    for (const std::string& name : names) {
        const Map& map = find_map(name);
        const DistanceNeeds more =
            map.distance != nullptr ? map.distance(options) : DistanceNeeds();
        needs.gradient = needs.gradient || more.gradient;
        needs.smooth = needs.smooth || more.smooth;
    }
    return needs;
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
