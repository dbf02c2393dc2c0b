#pragma once

#include "texgen/maps/map_image.h"
#include "texgen/maps/relief_options.h"

namespace foam::texgen {

class FrameLayers;

struct HeightOptions {
    double full = 0.5;  // what the largest code of a PNG stands for, in diameters
};

/// The height of the relief in diameters of its mean bubble. One channel.
NumberPixels draw_height(FrameLayers& layers,
                         const ReliefOptions& relief,
                         const HeightOptions& options);

}  // namespace foam::texgen
