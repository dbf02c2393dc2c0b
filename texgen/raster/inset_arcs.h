#pragma once

#include "texgen/raster/arcs/pixel_arc.h"
#include "texgen/raster/cell_arcs.h"
#include "texgen/raster/coords/pixel_frame.h"

#include <vector>

namespace foam::texgen {

/// What films leave free of each bubble of a torus: all its points at least `inset` > 0, in pixels,
/// away from its sides. `shapes` are those of the films.
CellArcs inset_arcs(const PixelFrame& pixels,
                    const std::vector<PixelArc>& shapes,
                    double inset,
                    int threads);

}  // namespace foam::texgen
