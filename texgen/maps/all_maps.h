// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/maps/age.h"
#include "texgen/maps/albedo.h"
#include "texgen/maps/albedo_options.h"
#include "texgen/maps/area.h"
#include "texgen/maps/caustics.h"
#include "texgen/maps/contour.h"
#include "texgen/maps/curvature.h"
#include "texgen/maps/distance.h"
#include "texgen/maps/emission.h"
#include "texgen/maps/event.h"
#include "texgen/maps/film.h"
#include "texgen/maps/growth.h"
#include "texgen/maps/height.h"
#include "texgen/maps/id.h"
#include "texgen/maps/id_color.h"
#include "texgen/maps/lit.h"
#include "texgen/maps/map.h"
#include "texgen/maps/maze.h"
#include "texgen/maps/metallic.h"
#include "texgen/maps/motion.h"
#include "texgen/maps/normal.h"
#include "texgen/maps/occlusion.h"
#include "texgen/maps/opacity.h"
#include "texgen/maps/pressure.h"
#include "texgen/maps/relief_options.h"
#include "texgen/maps/roughness.h"
#include "texgen/maps/sides.h"
#include "texgen/maps/thin_film.h"

#include <array>
#include <span>
#include <string>
#include <string_view>

namespace foam::texgen {

/// The options of all maps; each member is a table of a preset.
struct MapOptions {
    AlbedoOptions albedo;
    LitOptions lit;
    PressureOptions pressure;
    AreaOptions area;
    RoughnessOptions roughness;
    MetallicOptions metallic;
    AgeOptions age;
    GrowthOptions growth;
    EventMapOptions event_map;
    MotionOptions motion;
    DistanceOptions distance;
    ReliefOptions relief;  // used by all maps whose MapTraits::shows_relief is true
    HeightOptions height;
    NormalOptions normal;
    OcclusionOptions occlusion;
    CurvatureOptions curvature;
    ThinFilmOptions thin_film;
    MazeOptions maze;  // used by all maps that show a maze (shows_maze)
    ContourOptions contour;
    CausticsOptions caustics;
};

/// Returns the keys of all maps, such as "height.full", in the order in which presets list them.
/// The table of the map `event` is named event_map, because the table [[event]] describes an event
/// of the foam. The function is a template, so that only the few source files that call it compile
/// it.
template <class M = MapOptions>
Keys<M> map_keys() {
    return joined({nested_keys("albedo", &M::albedo, albedo_keys()),
                   nested_keys("lit", &M::lit, lit_keys()),
                   nested_keys("pressure", &M::pressure, pressure_keys()),
                   nested_keys("area", &M::area, area_keys()),
                   nested_keys("roughness", &M::roughness, roughness_keys()),
                   nested_keys("metallic", &M::metallic, metallic_keys()),
                   nested_keys("age", &M::age, age_keys()),
                   nested_keys("growth", &M::growth, growth_keys()),
                   nested_keys("event_map", &M::event_map, event_map_keys()),
                   nested_keys("motion", &M::motion, motion_keys()),
                   nested_keys("distance", &M::distance, distance_keys()),
                   nested_keys("relief", &M::relief, relief_keys()),
                   nested_keys("height", &M::height, height_keys()),
                   nested_keys("normal", &M::normal, normal_keys()),
                   nested_keys("occlusion", &M::occlusion, occlusion_keys()),
                   nested_keys("curvature", &M::curvature, curvature_keys()),
                   nested_keys("thin_film", &M::thin_film, thin_film_keys()),
                   nested_keys("maze", &M::maze, maze_keys()),
                   nested_keys("contour", &M::contour, contour_keys()),
                   nested_keys("caustics", &M::caustics, caustics_keys())});
}

/// Returns a map that is drawn by draw(layers, options.*members...). `note` becomes Map::note.
template <auto draw, auto... members>
constexpr Map map_of(const MapTraits& traits, std::string (*note)(const MapOptions&) = nullptr) {
    return {traits,
            [](FrameLayers& layers, const MapOptions& options) -> MapImage {
                return draw(layers, options.*members...);
            },
            note};
}

/// Returns a map of the relief that is drawn by draw(layers, source, options.*member), where
/// `source` is the ReliefSource of the options.
template <auto draw, auto member>
constexpr Map relief_map_of(const MapTraits& traits,
                            std::string (*note)(const MapOptions&) = nullptr) {
    return {traits,
            [](FrameLayers& layers, const MapOptions& options) -> MapImage {
                return draw(layers, {options.relief, options.maze}, options.*member);
            },
            note};
}

/// Returns a map of normals with a fixed direction of y.
template <NormalY y>
constexpr Map normal_map_of(const MapTraits& traits) {
    return {traits,
            [](FrameLayers& layers, const MapOptions& options) -> MapImage {
                return draw_normal(layers, {options.relief, options.maze}, {y});
            },
            [](const MapOptions&) { return note_on_normals({y}); }};
}

/// All maps, in the order in which the program lists them.
inline constexpr std::array kMaps = [] {
    using M = MapOptions;
    return std::array{
        map_of<draw_albedo, &M::albedo>(kAlbedoMap),
        map_of<draw_thin_film, &M::thin_film, &M::albedo>(kThinFilmMap),
        Map{kLitMap,
            [](FrameLayers& layers, const M& all) -> MapImage {
                return draw_lit(layers,
                                all.lit,
                                {all.albedo, all.thin_film, {all.relief, all.maze}, all.occlusion});
            }},
        Map{kEmissionMap,
            [](FrameLayers& layers, const M& all) -> MapImage {
                return draw_emission(
                    layers, {all.lit.colors, all.albedo, all.thin_film, all.maze}, all.lit.glow);
            }},
        map_of<draw_opacity, &M::albedo>(kOpacityMap),
        map_of<draw_film, &M::albedo>(kFilmMap),
        map_of<draw_distance, &M::distance, &M::albedo>(kDistanceMap),
        relief_map_of<draw_height, &M::height>(kHeightMap),
        relief_map_of<draw_normal, &M::normal>(
            kNormalMap, [](const M& options) { return note_on_normals(options.normal); }),
        normal_map_of<NormalY::Up>(kNormalGlMap),
        normal_map_of<NormalY::Down>(kNormalDxMap),
        relief_map_of<draw_occlusion, &M::occlusion>(kOcclusionMap),
        relief_map_of<draw_curvature, &M::curvature>(kCurvatureMap),
        map_of<draw_roughness, &M::roughness, &M::albedo>(kRoughnessMap),
        map_of<draw_metallic, &M::metallic, &M::albedo>(kMetallicMap),
        map_of<draw_pressure, &M::pressure>(kPressureMap),
        map_of<draw_area, &M::area>(kAreaMap),
        map_of<draw_sides>(kSidesMap),
        map_of<draw_id>(kIdMap),
        map_of<draw_id_color>(kIdColorMap),
        map_of<draw_age, &M::age>(kAgeMap),
        map_of<draw_growth, &M::growth>(kGrowthMap),
        map_of<draw_motion, &M::motion>(
            kMotionMap, [](const M& options) { return note_on_motion(options.motion); }),
        map_of<draw_event, &M::event_map>(kEventMap),
        map_of<draw_maze, &M::maze>(kMazeMap),
        map_of<draw_maze_solution, &M::maze>(kMazeSolutionMap),
        map_of<draw_contour, &M::contour, &M::pressure>(kContourMap),
        relief_map_of<draw_caustics, &M::caustics>(kCausticsMap)};
}();

/// Returns every map.
std::span<const Map> all_maps();

/// Returns the names of all maps, in the order of kMaps.
std::span<const std::string_view> map_names();

/// Returns the map with the given name. Throws std::invalid_argument if there is none; the message
/// lists all names and, if a name is similar, suggests it.
const Map& find_map(std::string_view name);

/// Returns the traits of the images that a map draws with the given options. These are
/// pressure_traits for the map `pressure`, and the traits of the map itself for all other maps.
const MapTraits& drawn_traits(const Map& map, const MapOptions& options);

/// Returns which images of the distance field are needed by at least one of the maps with the given
/// names. Throws as find_map does.
DistanceNeeds distance_needs(std::span<const std::string> names, const MapOptions& options);

/// Return the option that sets the range of a map (its key is Map::full_key), or nullptr if the map
/// has no such option.
AutoReal* range_option_of(const Map& map, MapOptions& options);
const AutoReal* range_option_of(const Map& map, const MapOptions& options);

/// Returns true if the image of a map can depend on the keys of a table of map_keys, such as
/// "relief".
bool uses_table(const Map& map, std::string_view table);

/// Returns false only if the image of a map cannot depend on a key of map_keys, such as
/// "albedo.colormap", when all other keys have the values in `options`. The result is false for all
/// keys of tables that the map does not use (uses_table), and for some keys of the other tables.
/// For example, most maps that use the table "albedo" use only its keys of films, and the maps
/// `lit` and `emission` use the colors of only one map (LitOptions::colors). The result is true for
/// all other keys. Some of these have no effect either, such as "lit.azimuth" for `emission`.
bool uses_key(const Map& map, std::string_view key, const MapOptions& options);

/// Returns true if at least one of the maps with the given names shows a maze (MapOptions::maze).
/// Precondition: all names are names of maps.
bool shows_maze(std::span<const std::string> names, const MapOptions& options);

/// Returns a Markdown table of all maps, which texgen/maps/MAPS.md contains.
std::string describe_maps_in_markdown();

}  // namespace foam::texgen
