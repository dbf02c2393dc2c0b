#pragma once

#include "texgen/raster/cell_place.h"
#include "texgen/raster/near_sides.h"
#include "texgen/raster/pixel_batch.h"
#include "texgen/raster/side_lanes.h"
#include "texgen/raster/small_mask.h"

#include <vector>

namespace foam::texgen {

/// A bubble of a torus of few sides and few pixels, which is placed, masked and measured as a
/// whole: with the bits that a CellMask and a RegionField have of it, in less time. Most bubbles
/// are of that kind if there are many. Keeps its memory from one bubble to the next.
class SmallCell {
  public:
    /// The pixels of a bubble, from its lower left corner.
    struct Pixels {
        int columns = 0;
        int rows = 0;            // of the whole bubble
        SmallMask::Rows wanted;  // of these
    };

    /// Whether the bubble is of that kind.
    bool place(const BubbleSides& sides, const CellPlace& at, const Pixels& pixels);

    /// The pixels that are wanted, measured.
    const PixelBatch& measure(DistanceNeeds needs);

  private:
    SmallMask mask_;
    NearSides sides_;
    PixelBatch batch_;
    double reach_ = 0.0;
    std::vector<FieldArc> films_;
};

}  // namespace foam::texgen
