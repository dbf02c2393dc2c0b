#pragma once

#include "texgen/raster/pixel_arc.h"

#include <cstddef>
#include <vector>

namespace foam::texgen {

/// A piece of an inset that is shorter, in pixels, is left out.
inline constexpr double kShortestPiece = 1e-6;

/// The boundary of an inset: closed loops of arcs, counter-clockwise around what they enclose.
struct ArcLoops {
    struct Arc {
        Vec2 tail{0.0, 0.0};
        PixelArc arc;  // ends where the next arc of the loop begins
    };
    std::vector<Arc> arcs;
    std::vector<std::size_t> loop_ends;  // one past the last arc of each loop
    int open_ends = 0;                   // pieces that found no successor; 0 for a valid bubble
};

}  // namespace foam::texgen
