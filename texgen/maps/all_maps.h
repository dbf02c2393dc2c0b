// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/maps/age.h"
#include "texgen/maps/albedo.h"
#include "texgen/maps/albedo_options.h"
#include "texgen/maps/area.h"
#include "texgen/maps/curvature.h"
#include "texgen/maps/distance.h"
#include "texgen/maps/event.h"
#include "texgen/maps/film.h"
#include "texgen/maps/growth.h"
#include "texgen/maps/height.h"
#include "texgen/maps/id.h"
#include "texgen/maps/id_color.h"
#include "texgen/maps/lit.h"
#include "texgen/maps/map.h"
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
    AgeOptions age;
    GrowthOptions growth;
    EventMapOptions event_map;
    MotionOptions motion;
    DistanceOptions distance;
    ReliefOptions relief;  // used by lit, height, normal, occlusion and curvature
    HeightOptions height;
    NormalOptions normal;
    OcclusionOptions occlusion;
    CurvatureOptions curvature;
    ThinFilmOptions thin_film;
};

/// Returns the keys of all maps, such as "height.full", in the order in which presets list them.
/// The table of the map `event` is named event_map, because the table [[event]] describes an event
/// of the foam. This is a template so that only the few sources that call it spend time compiling
/// it.
template <class M = MapOptions>
Keys<M> map_keys() {
    return joined({keys_in("albedo", &M::albedo, albedo_keys()),
                   keys_in("lit", &M::lit, lit_keys()),
                   keys_in("pressure", &M::pressure, pressure_keys()),
                   keys_in("area", &M::area, area_keys()),
                   keys_in("roughness", &M::roughness, roughness_keys()),
                   keys_in("age", &M::age, age_keys()),
                   keys_in("growth", &M::growth, growth_keys()),
                   keys_in("event_map", &M::event_map, event_map_keys()),
                   keys_in("motion", &M::motion, motion_keys()),
                   keys_in("distance", &M::distance, distance_keys()),
                   keys_in("relief", &M::relief, relief_keys()),
                   keys_in("height", &M::height, height_keys()),
                   keys_in("normal", &M::normal, normal_keys()),
                   keys_in("occlusion", &M::occlusion, occlusion_keys()),
                   keys_in("curvature", &M::curvature, curvature_keys()),
                   keys_in("thin_film", &M::thin_film, thin_film_keys())});
}

/// Makes a map that is drawn by draw(layers, options.*members...). `note` is Map::note.
template <auto draw, auto... members>
constexpr Map map_of(const MapTraits& traits, std::string (*note)(const MapOptions&) = nullptr) {
    return {traits,
            [](FrameLayers& layers, const MapOptions& options) -> MapImage {
                return draw(layers, options.*members...);
            },
            note};
}

/// Every map, in the order in which programs list them.
inline constexpr std::array kMaps = [] {
    using M = MapOptions;
    return std::array{
        map_of<draw_albedo, &M::albedo>(kAlbedoMap),
        map_of<draw_thin_film, &M::thin_film, &M::albedo>(kThinFilmMap),
        Map{kLitMap,
            [](FrameLayers& layers, const M& all) -> MapImage {
                return draw_lit(
                    layers, all.lit, {all.albedo, all.thin_film, all.relief, all.occlusion});
            }},
        map_of<draw_opacity, &M::albedo>(kOpacityMap),
        map_of<draw_film, &M::albedo>(kFilmMap),
        map_of<draw_distance, &M::distance, &M::albedo>(kDistanceMap),
        map_of<draw_height, &M::relief, &M::height>(kHeightMap),
        map_of<draw_normal, &M::relief, &M::normal>(
            kNormalMap, [](const M& options) { return note_on_normals(options.normal); }),
        map_of<draw_occlusion, &M::relief, &M::occlusion>(kOcclusionMap),
        map_of<draw_curvature, &M::relief, &M::curvature>(kCurvatureMap),
        map_of<draw_roughness, &M::roughness, &M::albedo>(kRoughnessMap),
        map_of<draw_pressure, &M::pressure>(kPressureMap),
        map_of<draw_area, &M::area>(kAreaMap),
        map_of<draw_sides>(kSidesMap),
        map_of<draw_id>(kIdMap),
        map_of<draw_id_color>(kIdColorMap),
        map_of<draw_age, &M::age>(kAgeMap),
        map_of<draw_growth, &M::growth>(kGrowthMap),
        map_of<draw_motion, &M::motion>(
            kMotionMap, [](const M& options) { return note_on_motion(options.motion); }),
        map_of<draw_event, &M::event_map>(kEventMap)};
}();

/// Returns every map.
std::span<const Map> all_maps();

/// Returns the names of all maps, in the order of kMaps.
std::span<const std::string_view> map_names();

/// Returns the map with the given name. Throws std::invalid_argument, with a list of the known
/// names, if there is none.
const Map& find_map(std::string_view name);

/// Returns the union of the needs of the maps with the given names.
DistanceNeeds distance_needs(std::span<const std::string> names, const MapOptions& options);

/// Returns the table of all maps that README.md contains, as Markdown.
std::string describe_maps_in_markdown();

}  // namespace foam::texgen
