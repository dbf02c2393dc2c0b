#pragma once

#include "texgen/raster/coords/pixel_frame.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

namespace foam::texgen {

/// All that a walk around a bubble of a torus asks of a film, whichever side it takes: in one line
/// of memory, as films lie anywhere. Pairs are of the forward side and of the other one.
struct alignas(64) FilmStep {
    double chord_x;  // of the forward side, pixels
    double chord_y;
    double cosine;  // of half the angle that it turns
    double sine;
    std::array<std::int32_t, 2> tail_x;  // subpixels
    std::array<std::int32_t, 2> tail_y;
    std::array<HalfEdgeId, 2> next;
    std::int32_t lift_x;  // subpixels from the head's junction to its copy, as seen from the tail
    std::int32_t lift_y;
};

/// Those of all films, by their index. `junctions` are the frame's, by theirs.
std::unique_ptr<FilmStep[]> film_steps(const PixelFrame& pixels,
                                       const std::vector<SubpixelPoint>& junctions,
                                       int threads);

}  // namespace foam::texgen
