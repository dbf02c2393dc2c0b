#pragma once

#include "texgen/maps/map_image.h"

namespace foam::texgen {

class FrameLayers;

struct GrowthOptions {
    double full = 0.05;  // what the largest code of a PNG stands for; the smallest for its negative
};

/// How fast every bubble grows on the way to the next frame: the change of its area over the foam
/// time, mixed where pixels are shared. That of one that vanishes is all it has. Without anything
/// imposed and without T2 around it that is von Neumann's law. One channel; 0 around a patch, and
/// everywhere where no time passes. Needs the next frame: throws std::invalid_argument without.
NumberPixels draw_growth(FrameLayers& layers, const GrowthOptions& options);

}  // namespace foam::texgen
