#pragma once

#include "texgen/maps/map_image.h"

namespace foam::texgen {

class FrameLayers;

/// When a bubble's age begins.
enum class AgeSince {
    Birth,   // of the seeded ones at foam time 0
    Change,  // when it last lost or won a neighbour
};

struct AgeOptions {
    AgeSince since = AgeSince::Birth;
    double full = 50.0;  // what the largest code of a PNG stands for, foam time
};

/// The age of every bubble in foam time, mixed where pixels are shared. One channel; 0 around a
/// patch.
NumberPixels draw_age(FrameLayers& layers, const AgeOptions& options);

}  // namespace foam::texgen
