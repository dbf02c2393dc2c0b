#pragma once

#include "texgen/maps/map_image.h"
#include "texgen/maps/relief_options.h"

namespace foam::texgen {

class FrameLayers;

struct CurvatureOptions {
    double radius = 0.08;  // what is felt around a place, in diameters of the relief's mean bubble
    double full = 10.0;    // what the largest code of a PNG stands for; the smallest for its
                           // negative
};

/// How the relief bends across the nearest film, over a radius a: (2 h(x) - h(x - a) - h(x + a)) /
/// a², times the diameter of the mean bubble. Positive on crests, negative in furrows, 0 where it
/// is flat or straight. One channel; 0 around a patch.
NumberPixels draw_curvature(FrameLayers& layers,
                            const ReliefOptions& relief,
                            const CurvatureOptions& options);

}  // namespace foam::texgen
