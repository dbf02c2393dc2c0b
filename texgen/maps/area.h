#pragma once

#include "texgen/maps/map_image.h"
#include "texgen/maps/mean_bubble.h"

namespace foam::texgen {

class FrameLayers;

struct AreaOptions {
    MeanBubble unit = MeanBubble::Current;
    double full = 4.0;  // what the largest code of a PNG stands for, in the unit
};

/// The area of every bubble within its arcs, mixed where pixels are shared. One channel; 0 around a
/// patch.
NumberPixels draw_area(FrameLayers& layers, const AreaOptions& options);

}  // namespace foam::texgen
