// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/foam/frame.h"
#include "texgen/raster/coords/raster_grid.h"

namespace foam::texgen {

/// A frame on a torus, in the coordinates of the unshifted grid (RasterGrid). Borrows the frame.
/// The constructor throws the exceptions of pixels_per_unit, for example if the grid and the domain
/// of the frame do not fit together.
struct PixelFrame {
    PixelFrame(const Frame& torus_frame, const RasterGrid& raster_grid)
        : frame(torus_frame),
          grid(raster_grid),
          scale(pixels_per_unit(raster_grid, torus_frame.domain)),
          shear(shear_in_subpixels(raster_grid, torus_frame.domain)),
          snap(raster_grid, torus_frame.domain) {}

    /// Returns the position of a junction, rounded to subpixels.
    SubpixelPoint rounded_position(JunctionId junction) const {
        return snap(frame.positions[junction]);
    }
    /// Returns the position of a junction in pixels, not rounded.
    Vec2 exact_position(JunctionId junction) const { return scale * frame.positions[junction]; }
    /// Returns a lattice offset as a translation in subpixels.
    SubpixelPoint translation(LatticeOffset offset) const {
        return {offset.i * grid.width * kSubpixel + offset.j * shear,
                offset.j * grid.height * kSubpixel};
    }

    const Frame& frame;
    RasterGrid grid;
    double scale;        // pixels per foam unit
    std::int32_t shear;  // subpixels
    Snap snap;
};

}  // namespace foam::texgen
