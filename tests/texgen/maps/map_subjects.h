// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/foam/frame.h"
#include "texgen/maps/all_maps.h"
#include "texgen/maps/frame_layers.h"

#include <string_view>

namespace foam::texgen::test {

/// A frame with all that maps ask for.
struct MapSubject {
    Frame frame;
    Frame next;  // a step later
    FoamRecord record;

    FrameInput input() const { return {frame, record, &next}; }
};

/// A foam of very different areas on a square torus.
const MapSubject& torus_subject();

/// A patch with a hole, and a lone bubble beside it.
const MapSubject& patch_subject();

/// A grid of so many pixels a side: of a torus, shifted, or of the whole patch.
RasterGrid torus_grid(int size, int shift_x = 0, int shift_y = 0);
RasterGrid patch_grid(int size);

/// A map of a subject.
MapImage draw(std::string_view map,
              const MapSubject& subject,
              const RasterGrid& grid,
              int threads = 1,
              const MapOptions& options = {});

}  // namespace foam::texgen::test
