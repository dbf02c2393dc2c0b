#pragma once

#include "texgen/raster/distance.h"
#include "texgen/raster/near_sides.h"

#include <span>

namespace foam::texgen {

/// The films of a region, which its smooth distances are made from.
struct SmoothFilms {
    std::span<const FieldArc> films;
    bool whole_circle = false;  // such a film has no ends
};

/// Measures all that is needed of a batch of a region, of which no pixel is farther from its middle
/// than `reach`. The films are only asked for where smooth distances are.
void measure(NearSides& sides,
             const SmoothFilms& films,
             double reach,
             DistanceNeeds needs,
             PixelBatch& batch);

}  // namespace foam::texgen
