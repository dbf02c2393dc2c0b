#pragma once

#include "texgen/maps/frame_layers.h"
#include "texgen/maps/map_image.h"

namespace foam::texgen {

/// What areas are measured in: the mean area of the seeded foam, which is 1, or that of the frame.
enum class AreaUnit { Seed, Current };

struct AreaOptions {
    AreaUnit unit = AreaUnit::Current;
    double full = 4.0;  // what the largest code of a PNG stands for, in the unit
};

/// The area of every bubble within its arcs, mixed where pixels are shared. One channel; 0 around a
/// patch.
NumberPixels draw_area(FrameLayers& layers, const AreaOptions& options);

}  // namespace foam::texgen
