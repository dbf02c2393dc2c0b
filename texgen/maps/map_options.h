#pragma once

#include "texgen/maps/albedo.h"
#include "texgen/maps/area.h"
#include "texgen/maps/pressure.h"

namespace foam::texgen {

/// How every map is drawn.
struct MapOptions {
    AlbedoOptions albedo;
    PressureOptions pressure;
    AreaOptions area;
};

}  // namespace foam::texgen
