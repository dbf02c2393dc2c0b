// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/foam/frame.h"
#include "core/parallel/parallel_for.h"
#include "texgen/raster/coords/raster_grid.h"

#include <cstddef>
#include <vector>

namespace foam::texgen {

/// A frame on a torus, in the coordinates of the unshifted grid. Borrows the frame. The constructor
/// throws the exceptions of pixels_per_unit.
struct PixelFrame {
    PixelFrame(const Frame& of, const RasterGrid& on)
        : frame(of),
          grid(on),
          scale(pixels_per_unit(on, of.domain)),
          shear(shear_in_subpixels(on, of.domain)),
          snap(on, of.domain) {}

    /// Returns the position of a junction, rounded to subpixels.
    SubpixelPoint rounded_position(JunctionId junction) const {
        return snap(frame.positions[junction]);
    }
    /// Returns the rounded positions of all junctions, indexed by JunctionId.
    std::vector<SubpixelPoint> rounded_positions(int threads) const {
        constexpr std::size_t kPerTask = 8192;
        std::vector<SubpixelPoint> points(frame.positions.size());
        parallel_for(points.size(), kPerTask, threads, [&](std::size_t first, std::size_t last) {
            for (std::size_t k = first; k < last; ++k) {
                points[k] = rounded_position(id_at<JunctionId>(k));
            }
        });
        return points;
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
