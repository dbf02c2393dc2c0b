// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/foam/frame.h"
#include "texgen/maps/all_maps.h"
#include "texgen/maps/frame_layers.h"

#include <string_view>

namespace foam::texgen::test {

/// A frame with all data that maps need.
struct MapSubject {
    Frame frame;
    Frame next;  // the frame after one more time step
    FoamRecord record;

    FrameInput input() const { return {frame, record, &next}; }
};

/// Returns a foam of very different areas on a square torus.
const MapSubject& torus_subject();

/// Returns a patch with a hole, and a lone bubble beside it.
const MapSubject& patch_subject();

/// Return a grid of `size` x `size` pixels: for the torus, with a shift in pixels, or for the whole
/// patch.
RasterGrid torus_grid(int size, int shift_x = 0, int shift_y = 0);
RasterGrid patch_grid(int size);

/// Draws a map of a subject.
MapImage draw(std::string_view map,
              const MapSubject& subject,
              const RasterGrid& grid,
              int threads = 1,
              const MapOptions& options = {});

}  // namespace foam::texgen::test
