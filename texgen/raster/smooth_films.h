#pragma once

#include "texgen/raster/field_arc.h"
#include "texgen/raster/pixel_batch.h"

#include <span>

namespace foam::texgen {

/// Finds the smooth distances of a batch of a region, of which no pixel is farther from its middle
/// than `reach`, from the region's films. A film that is a `whole_circle` has no ends. Normalized
/// gradients have to be there.
void measure_smooth(std::span<const FieldArc> films,
                    bool whole_circle,
                    double reach,
                    PixelBatch& batch);

}  // namespace foam::texgen
