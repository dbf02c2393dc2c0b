#pragma once

#include "texgen/maps/age.h"
#include "texgen/maps/albedo.h"
#include "texgen/maps/area.h"
#include "texgen/maps/curvature.h"
#include "texgen/maps/distance.h"
#include "texgen/maps/event.h"
#include "texgen/maps/growth.h"
#include "texgen/maps/height.h"
#include "texgen/maps/lit.h"
#include "texgen/maps/motion.h"
#include "texgen/maps/normal.h"
#include "texgen/maps/occlusion.h"
#include "texgen/maps/pressure.h"
#include "texgen/maps/relief_options.h"
#include "texgen/maps/roughness.h"
#include "texgen/maps/thin_film.h"

namespace foam::texgen {

/// How every map is drawn.
struct MapOptions {
    AlbedoOptions albedo;
    PressureOptions pressure;
    AreaOptions area;
    RoughnessOptions roughness;
    AgeOptions age;
    GrowthOptions growth;
    EventMapOptions event_map;
    MotionOptions motion;
    DistanceOptions distance;
    ReliefOptions relief;  // of height, normal, occlusion and curvature
    HeightOptions height;
    NormalOptions normal;
    OcclusionOptions occlusion;
    CurvatureOptions curvature;
    ThinFilmOptions thin_film;
    LitOptions lit;
};

}  // namespace foam::texgen
